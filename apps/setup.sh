#!/usr/bin/env bash
# Reye on an empty Debian 12: installs what is missing, builds, then runs the demo, the tests or a case.
#
#   bash apps/setup.sh demo           the fretting demo; ends with where its page, pictures and series lie
#   bash apps/setup.sh test           the test suite without the long and the slow ones
#   bash apps/setup.sh test long      the test suite without the slow ones
#   bash apps/setup.sh build          packages and build only
#   bash apps/setup.sh results CASE   remakes results/CASE and compares; CASE = all does every one
#
# REYE_MPI=ON in the environment builds what mpirun needs, too (src/algebra/README.md).
#
# As root or with sudo. A second call installs nothing and rebuilds nothing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(
  g++ cmake ninja-build make pkg-config git ca-certificates python3 python3-jsonschema dpkg-dev file
  libgmsh-dev libeigen3-dev libsuitesparse-dev libopenblas-dev libtbb-dev libcgal-dev libvtk9-dev
  libtomlplusplus-dev libmuparser-dev libcli11-dev nlohmann-json3-dev libcereal-dev
  pybind11-dev python3-dev python3-numpy
  libgtest-dev libgmock-dev libbenchmark-dev gnuplot-nox clang-format
)
build=build
[ "${REYE_MPI:-OFF}" = OFF ] || packages+=(libmumps-dev mpi-default-dev)   # factors of solids on several processes

usage() {
  sed -n '2,12s/^# \{0,1\}//p' apps/setup.sh
  exit 2
}

missing_packages() {
  local package
  for package in "${packages[@]}"; do
    dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive "$@"
  elif command -v sudo >/dev/null; then
    sudo env DEBIAN_FRONTEND=noninteractive "$@"
  else
    echo "setup: packages are missing; run as root or install sudo: $*" >&2
    exit 1
  fi
}

install_missing() {
  local missing
  mapfile -t missing < <(missing_packages)
  [ "${#missing[@]}" -gt 0 ] || return 0
  echo "setup: installing ${missing[*]}"
  as_root apt-get -o Acquire::Retries=3 update </dev/null
  as_root apt-get -o Acquire::Retries=3 install -y --no-install-recommends "${missing[@]}" </dev/null
}

# Builds the targets that are named, or all. Where ccache is there, it knows precompiled headers by their content.
build() {
  local launcher=()
  if command -v ccache >/dev/null; then
    launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
  fi
  [ -f "$build/build.ninja" ] || cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DREYE_WERROR="${REYE_WERROR:-OFF}" "${launcher[@]}"
  [ -z "${REYE_MPI:-}" ] || cmake -DREYE_MPI="$REYE_MPI" "$build" >/dev/null
  cmake --build "$build" --parallel "$(nproc)" ${1:+--target "$@"}   # ninja alone starts two more, which share caches
}

run_demo() {
  local out="$build/fretting_demo.out"
  "$build/bin/reye" run geo/fretting_demo/scene.toml --out "$out"
  [ -f "$out/report.html" ] || "$build/bin/reye" report "$out"
  python3 apps/results.py table "$out"
}

# The programs of the build that the cases named run: all of them for all.
programs_of() {
  local program files=("results/$1/"make.*)
  [ "$1" != all ] || files=(results/*/make.*)
  local programs=(reye reye-bench test_stability test_verification test_slow)
  [ "${REYE_MPI:-OFF}" = OFF ] || programs+=(reye-ranks)
  for program in "${programs[@]}"; do
    [ "$program" != reye ] && ! grep -qs -- "$program" "${files[@]}" || echo "$program"
  done
}

[ $# -ge 1 ] || usage
case "$1" in
  test) [ $# -eq 1 ] || { [ $# -eq 2 ] && [ "$2" = long ]; } || usage ;;
  demo | build) [ $# -eq 1 ] || usage ;;
  results) [ $# -eq 2 ] || usage ;;
  *) usage ;;
esac

install_missing
case "$1" in
  demo) build reye; run_demo ;;
  build) build ;;
  test)
    build
    left_out='slow|long'
    [ $# -eq 1 ] || left_out=slow
    # Tests of the command wait a tenth of their time for files, children and signals: one more than there are cores.
    ctest --test-dir "$build" --output-on-failure -LE "$left_out" -j "$(($(nproc) + 1))"
    ;;
  results) mapfile -t programs < <(programs_of "$2"); build "${programs[@]}"; python3 apps/results.py compare "$2" ;;
esac
