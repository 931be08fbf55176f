#!/bin/sh
# Installs the Debian packages that millwear needs: `run` for using it, `test` for its tests too.
# Does nothing where all are there; without root it says what to install.
set -eu

for_running="build-essential cmake ninja-build pkg-config
  liggghts libliggghts-dev openmpi-bin libopenmpi-dev
  libgmsh-dev libgsl-dev libhdf5-dev libeigen3-dev libpolyclipping-dev libdxflib-dev libgdal-dev
  libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libxxhash-dev libcereal-dev libdlib-dev zlib1g-dev
  gnuplot-nox tachyon-bin-nox libjs-d3 node-pako"
for_testing="clang-format libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libboost-dev chromium
  slurmctld slurmd slurm-client"

case "${1:-run}" in
  run) wanted=$for_running ;;
  test) wanted="$for_running $for_testing" ;;
  *) echo "usage: $0 [run|test]" >&2; exit 2 ;;
esac

missing=""
for package in $wanted; do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$state" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -ne 0 ]; then
  echo "millwear needs packages that only root can install. Run:" >&2
  echo "  sudo apt-get install --no-install-recommends$missing" >&2
  exit 1
fi
echo "installing:$missing"
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
# shellcheck disable=SC2086  # the list is meant to be split
apt-get install -y -qq --no-install-recommends $missing >/dev/null
