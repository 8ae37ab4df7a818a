# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
# Which of Debian's packages are needed for what, and how they are installed; to be sourced.

# The names are the same on Debian 11, 12 and 13.
packages_of() {
  case $1 in
    build)
      echo g++ make cmake pkg-config catkin \
        libassimp-dev libconsole-bridge-dev libeigen3-dev libtinyxml2-dev liburdfdom-dev \
        libroscpp-dev librospack-dev libtf2-dev ros-message-generation \
        libdiagnostic-msgs-dev libgeometry-msgs-dev libros-rosgraph-msgs-dev libstd-msgs-dev \
        libstd-srvs-dev libtf2-msgs-dev libvisualization-msgs-dev \
        ros-diagnostic-msgs ros-geometry-msgs ros-sensor-msgs ros-std-msgs ros-std-srvs \
        ros-tf2-msgs ros-visualization-msgs ;;
    run)  # what the launch files start, and the command line for looking at it
      echo python3 python3-rospy python3-roslaunch python3-rosgraph rosout ros-robot-state-publisher \
        python3-diagnostic-msgs python3-geometry-msgs python3-sensor-msgs python3-std-msgs \
        python3-std-srvs python3-tf2-msgs python3-visualization-msgs \
        ros-environment rosbash rospack-tools python3-rosbag python3-rosmsg python3-rosnode \
        python3-rosparam python3-rosservice python3-rostopic ;;
    test)
      echo libgtest-dev librostest-dev python3-rostest python3-rosgraph-msgs python3-tf2-ros ;;
    display)
      echo rviz libgl1-mesa-dri ;;
    lint)
      echo catkin-lint clang-format ;;
    *)
      fail "no group of packages is called $1" ;;
  esac
}

# install_packages GROUP ...
install_packages() {
  command -v apt-get >/dev/null && command -v dpkg-query >/dev/null ||
    fail "this script installs Debian's packages, and there is no apt-get here;" \
      "README.md says what to install by hand"
  local missing log=$BUILD/install.log
  read -ra missing < <(missing_packages "$@") || true
  [ ${#missing[@]} -gt 0 ] || return 0
  say "Installing ${missing[*]} (takes a minute or two, the log is $log)"
  mkdir -p "$BUILD"
  as_root true || fail "installing needs root, and sudo asks for a password or is not there;" \
    "as root, please: apt-get update; apt-get install --no-install-recommends ${missing[*]}"
  { as_root apt-get update -q &&
    as_root apt-get install -y -q --no-install-recommends "${missing[@]}"
  } >"$log" 2>&1 </dev/null || {
    tail -n 20 "$log" >&2
    fail "installing failed; all of it is in $log"
  }
}

missing_packages() {
  local group name
  for group; do
    for name in $(packages_of "$group"); do
      dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null | grep -qx installed ||
        echo "$name"
    done
  done | tr '\n' ' '
}

# Never asks: apt-get answers by itself, sudo either works without a password or not at all.
as_root() {
  local command=(env DEBIAN_FRONTEND=noninteractive NEEDRESTART_MODE=a "$@")
  [ "$(id -u)" = 0 ] || command=(sudo -n "${command[@]}")
  "${command[@]}"
}
