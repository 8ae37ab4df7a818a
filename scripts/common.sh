# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 The link_bounds authors
# SPDX-License-Identifier: BSD-3-Clause
# What all scripts share: a clean environment, messages, the build, a port; to be sourced.

REPO=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
BUILD=$REPO/build
# shellcheck source=scripts/packages.sh
. "$REPO/scripts/packages.sh"

say() { printf '\n==> %s\n' "$*"; }

# from_package_xml TAG
from_package_xml() { sed -n "s:^ *<$1[^>]*>\(.*\)</$1>$:\1:p" "$REPO/package.xml"; }

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# Uses the system's own tools only: catkin and the Python nodes fail with a python3 of pyenv or
# conda, and a workspace that happens to be sourced must not get into the build.
clean_environment() {
  refuse_other_ros
  export PATH=/usr/sbin:/usr/bin:/sbin:/bin
  unset PYTHONPATH PYTHONHOME PYTHONSTARTUP VIRTUAL_ENV CONDA_PREFIX
  unset CMAKE_PREFIX_PATH PKG_CONFIG_PATH LD_LIBRARY_PATH
  unset ROS_PACKAGE_PATH ROS_ROOT ROS_DISTRO ROS_PYTHON_VERSION ROS_NAMESPACE
  export ROS_HOME=$BUILD/ros_home
  export ROS_LOG_DIR=$ROS_HOME/log
}

# refuse_other_ros [ROOT]: the packages of ROS from elsewhere and those of Debian exclude each other.
# Ubuntu has Debian's in 20.04 and 22.04 only; packages.sh has the names of 22.04.
# ROOT is the folder in which the system lies.
refuse_other_ros() {
  local root=${1:-} remedy="doc/deployment.md, section Noetic or ROS One, says how to build there"
  local other=${ROS_DISTRO:-} codename setup
  codename=$(sed -n 's/^UBUNTU_CODENAME=//p' "$root/etc/os-release" 2>/dev/null) || true
  [ "$other" != Debian ] || other=
  if [ -z "$other" ] && [ -n "$codename" ]; then
    for setup in "$root"/opt/ros/*/setup.sh; do
      [ ! -e "$setup" ] || other=$(basename "$(dirname "$setup")")
    done
    ! grep -rqsE '^[^#]*(packages\.ros\.org|ros\.packages\.)' "$root"/etc/apt/sources.list{,.d} ||
      other=${other:-of another apt repository}
  fi
  [ -z "${ROS_DISTRO:-}" ] || [ "$other" != "$ROS_DISTRO" ] ||
    remedy+=", or start from a shell that has not sourced another ROS"
  [ -z "$other" ] || fail "ROS $other is set up here, but this script builds with the ROS packages" \
    "of Debian or Ubuntu: $remedy"
  case $codename in
    '' | jammy) ;;
    focal) fail "Ubuntu's release focal is too old for this script: install ROS Noetic, and build with" \
      "rosdep and catkin; doc/deployment.md, section Noetic, has the commands" ;;
    *) fail "Ubuntu's release $codename has no packages of ROS 1: install ROS One;" \
      "doc/deployment.md, section ROS One, has the commands" ;;
  esac
}

# Lets nodes find each other on a machine whose own name does not resolve, unless the user has set
# an address.
use_localhost() {
  [ -n "${ROS_IP:-}${ROS_HOSTNAME:-}" ] || export ROS_HOSTNAME=localhost
}

# The number of compilers to run: one per processor, but not more than one per GB of memory.
jobs_of_machine() {
  local gigabytes
  gigabytes=$(awk '/^MemTotal/ { print int($2 / 1e6) + 1 }' /proc/meminfo)
  if [ "$gigabytes" -lt "$(nproc)" ]; then echo "$gigabytes"; else nproc; fi
}

# Whether the folder was configured to the end, and for this checkout.
is_configured() {
  [ -s "$1/Makefile" ] &&
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$REPO" "$1/CMakeCache.txt"
}

# What a build folder without tests takes; with tests, it is 900.
BUILD_MEGABYTES=600

# check_disk FOLDER: fails, and names the disk, where there is not enough room for what a build still
# has to write into the folder.
check_disk() {
  local free mount taken needed
  read -r free mount < <(df -Pm "$1" | awk 'NR == 2 { print $4, $6 }')
  taken=$(du -sm "$1" | cut -f 1)
  needed=$((BUILD_MEGABYTES - taken))
  [ "$needed" -ge 200 ] || needed=200  # while it runs, the compiler writes files beside its results
  [ "$free" -ge "$needed" ] || fail "the disk of $1, mounted on $mount, is full: $free MB are free," \
    "about $needed MB are needed; make room there and start again"
}

# configure FOLDER [CMAKE_OPTION ...]
configure() {
  local folder=$1 log=$1/configure.log
  shift
  mkdir -p "$folder"
  is_configured "$folder" || check_disk "$folder"
  say "Configuring $folder"
  # Removes what a checkout that was moved, or a configuration that failed, has left.
  is_configured "$folder" || rm -rf "$folder"/{CMakeCache.txt,CMakeFiles,catkin_generated,devel}
  # On a full disk, cmake may report success and leave no Makefile.
  if ! cmake -S "$REPO" -B "$folder" -DPYTHON_EXECUTABLE=/usr/bin/python3 "$@" >"$log" 2>&1 ||
    ! is_configured "$folder"; then
    tail -n 40 "$log" >&2
    check_disk "$folder"
    fail "configuring failed; the complete log is $log"
  fi
}

# build FOLDER TARGET ...
build() {
  local folder=$1
  shift
  say "Building $folder"
  cmake --build "$folder" --parallel "$(jobs_of_machine)" --target "$@" || {
    check_disk "$folder"
    return 1
  }
}

# Prints a port on which nobody listens.
free_port() {
  python3 "$REPO/test/testing/free_port.py"
}

# Here $1 is the first argument of the script that sources this file.
if [ "${1:-}" = --version ]; then
  echo "${0##*/} of link_bounds $(from_package_xml version)"
  exit 0
fi
