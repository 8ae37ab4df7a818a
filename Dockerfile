# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
# The packages for apt, built and installed; doc/deployment.md says how to use the image. scripts/container
# runs the same steps without a container engine.
FROM debian:12
COPY . /link_bounds
RUN /link_bounds/scripts/deb
RUN apt-get update && apt-get install -y --no-install-recommends \
  /link_bounds/build/deb/link-bounds_*.deb /link_bounds/build/deb/python3-link-bounds_*.deb \
  /link_bounds/build/deb/liblink-bounds0_*.deb ros-robot-state-publisher python3-sensor-msgs
CMD ["roslaunch", "link_bounds", "demo.launch", "rviz:=false"]
