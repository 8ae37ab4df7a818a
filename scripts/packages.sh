# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
# Debian's packages by purpose, and how they are installed; to be sourced.

# The names are the same on Debian 11, 12, 13 and sid, and on Ubuntu 22.04.
packages_of() {
  case $1 in
    build)
      echo g++ make cmake pkg-config catkin \
        libassimp-dev libbz2-dev libconsole-bridge-dev libeigen3-dev liblz4-dev libtinyxml2-dev \
        liburdfdom-dev libyaml-cpp-dev \
        libroscpp-dev librospack-dev libtf2-dev ros-message-generation \
        pybind11-dev python3-dev python3-setuptools \
        libdiagnostic-msgs-dev libgeometry-msgs-dev libros-rosgraph-msgs-dev libsensor-msgs-dev \
        libstd-msgs-dev \
        libstd-srvs-dev libtf2-msgs-dev libtrajectory-msgs-dev libvisualization-msgs-dev \
        ros-diagnostic-msgs ros-geometry-msgs ros-sensor-msgs ros-std-msgs ros-std-srvs \
        ros-tf2-msgs ros-trajectory-msgs ros-visualization-msgs ;;
    nodelet)  # what cloud_filter is built with as a nodelet, where it exists
      echo libnodeletlib-dev ;;
    manager)  # what loads it
      echo libnodeletlib-tools ;;
    run)  # what the launch files start, assert_box in a .test file, and the command line tools to
          # look at it; rosmsg reads the messages in ros-*-msgs and the manifests in lib*-msgs-dev
      echo python3 python3-numpy python3-rospkg python3-rospy python3-roslaunch python3-rosgraph python3-rostest \
        rosout ros-diagnostic-msgs ros-geometry-msgs ros-std-msgs ros-std-srvs ros-tf2-msgs \
        ros-trajectory-msgs ros-visualization-msgs libdiagnostic-msgs-dev libgeometry-msgs-dev libstd-msgs-dev \
        libstd-srvs-dev libtf2-msgs-dev libtrajectory-msgs-dev libvisualization-msgs-dev \
        python3-diagnostic-msgs python3-geometry-msgs python3-std-msgs python3-std-srvs \
        python3-tf2-msgs python3-trajectory-msgs python3-visualization-msgs \
        ros-environment rosbash rospack-tools tf2-tools python3-rosbag python3-rosmsg python3-rosnode \
        python3-rosparam python3-rosservice python3-rostopic ;;
    demo)  # what only the demos need, and the tests
      echo ros-robot-state-publisher libsensor-msgs-dev python3-sensor-msgs python3-tf2-ros \
        ros-sensor-msgs ;;
    test)
      echo iproute2 libgtest-dev librostest-dev python3-rosgraph-msgs python3-roslib \
        python3-rosmaster python3-rosunit python3-tf2-ros \
        python3-yaml ;;
    display)
      echo rviz libgl1-mesa-dri ;;
    link)  # what the headers of the library and of the messages include
      echo libeigen3-dev libgeometry-msgs-dev libstd-msgs-dev libtrajectory-msgs-dev ros-message-runtime ;;
    deb)
      echo build-essential debhelper dh-python dpkg-dev ;;
    bench)
      echo libbenchmark-dev libtf2-ros-dev ;;
    peers)  # what is measured beside us; not all of them exist on every system
      echo libbullet-dev libfcl-dev libgeometric-shapes-dev librosbag-storage-dev ;;
    clouds)  # what filters clouds beside us: 1.3 GB with all that it depends on
      echo libpcl-dev ;;
    count)  # what counts cache lines
      echo valgrind ;;
    fuzz)  # Debian 11 has libFuzzer in a package that clang depends on
      echo clang libclang-rt-dev ;;
    arm64)  # what makes, compiles and emulates a system for ARM
      echo debootstrap qemu-user-static binfmt-support g++-aarch64-linux-gnu ;;
    machines)  # what distributes bags
      echo munge openssh-client openssh-server parallel slurm-wlm ;;
    plot)
      echo python3-matplotlib ;;
    pictures)
      echo fonts-dejavu-core graphviz imagemagick python3-pil python3-tf2-ros xvfb ;;
    lint)
      echo catkin-lint clang-format doxygen lintian ;;
    *)
      fail "no group of packages is called $1" ;;
  esac
}

# install_packages GROUP ...
install_packages() {
  local missing
  read -ra missing < <(missing_packages "$@") || true
  [ ${#missing[@]} -eq 0 ] || install_named "${missing[@]}"
}

# install_named PACKAGE ...
install_named() {
  local log=$BUILD/install.log
  command -v apt-get >/dev/null && command -v dpkg-query >/dev/null ||
    fail "this script installs Debian's packages, and there is no apt-get here;" \
      "doc/deployment.md says what to install by hand"
  say "Installing $* (takes a minute or two, the log is $log)"
  mkdir -p "$BUILD"
  ask_for_root
  as_root true || fail "installing needs root, and sudo asks for a password or is not there;" \
    "as root, please: apt-get update; apt-get install --no-install-recommends $*"
  # A repository that cannot be read may be one that is not needed.
  { as_root apt-get update -q || true
    as_root apt-get install -y -q --no-install-recommends "$@"
  } >"$log" 2>&1 </dev/null || {
    { grep '^[EW]: ' "$log" || true
      tail -n 20 "$log"
    } | awk '!seen[$0]++' >&2
    fail "installing failed; the complete log is $log"
  }
}

# install_what_exists GROUP: as install_packages, but only names the packages that this system does
# not have.
install_what_exists() {
  local name missing
  read -ra missing < <(missing_packages "$1") || true
  [ ${#missing[@]} -eq 0 ] || has_lists || get_lists
  for name in "${missing[@]}"; do
    if exists "$name"; then
      (install_named "$name") || say "$name could not be installed; it is left out"
    else
      say "There is no package $name here; it is left out"
    fi
  done
}

get_lists() {
  local log=$BUILD/lists.log
  mkdir -p "$BUILD"
  ask_for_root
  as_root apt-get update -q >"$log" 2>&1 </dev/null || say "apt-get update failed; the log is $log"
}

exists() { apt-cache show "$1" >/dev/null 2>&1; }

# The lists of a usable system have apt itself.
has_lists() { [ -n "$(apt-cache madison apt 2>/dev/null)" ]; }

missing_packages() {
  local group name
  for group; do
    for name in $(packages_of "$group"); do
      dpkg-query -W -f '${db:Status-Status}\n' "$name" 2>/dev/null | grep -qx installed ||
        echo "$name"
    done
  done | tr '\n' ' '
}

# The user at a terminal is asked for the password of sudo.
ask_for_root() { as_root true 2>/dev/null || { [ -t 0 ] && sudo -v; } || true; }

# Asks nothing: apt-get takes its defaults, and sudo fails where it would want a password.
as_root() {
  local command=(env DEBIAN_FRONTEND=noninteractive NEEDRESTART_MODE=a "$@")
  [ "$(id -u)" = 0 ] || command=(sudo -n "${command[@]}")
  "${command[@]}"
}
