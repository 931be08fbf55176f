#!/bin/sh
# Installs a build into an empty prefix and uses it from outside: the example, pkg-config, the
# pages, and what find_package refuses.
#   consumer_test.sh BUILD CHECKOUT EMPTY_FOLDER [COMPILER_LAUNCHER]
set -eu
build=$1 checkout=$2 work=$3 launcher=${4:-}
rm -rf "$work"
mkdir -p "$work"
cd "$work"
prefix=$work/prefix

failed() { echo "FAILED: $1" >&2; exit 1; }

cmake --install "$build" --prefix "$prefix" >install.log
library=$(dirname "$(dirname "$(find "$prefix" -name millwear.pc)")")

# --- programs and pages
"$prefix/bin/millwear" --version | grep -q '^millwear [0-9]' || failed 'the installed program runs'
[ -x "$prefix/bin/millwear-recorder" ] || failed 'the recorder lies beside the program'
grep -q '^\.SS calibrate' "$prefix/share/man/man1/millwear.1" || failed 'the man page has a section a verb'
completed=$(bash -c '. "$1"; COMP_WORDS=(millwear run --exp); COMP_CWORD=2; _millwear; echo "${COMPREPLY[*]}"' \
  - "$prefix/share/bash-completion/completions/millwear")
[ "$completed" = --explain ] || failed "run --exp is completed to --explain, not to '$completed'"

# --- headers: each finds what it includes, and only Eigen's are another's
cd "$prefix/include/millwear"
for header in $(grep -rhoE '^#include "[^"]+' . | sed 's/#include "//' | sort -u); do
  [ -f "$header" ] || failed "the header $header is included and not installed"
done
foreign=$(grep -rnE '^#include <[^>]*[/.]' . | grep -v '<Eigen/' || true)
[ -z "$foreign" ] || failed "the headers need only Eigen: $foreign"
cd "$work"

# --- nothing of our own build is handed on
leaked=$(grep -rnE -e '-W[a-z]|-fsanitize|nlohmann|millwear_options' "$library/cmake" "$library/pkgconfig" || true)
[ -z "$leaked" ] || failed "the package hands on: $leaked"
for path in "$checkout" "$build" "$prefix"; do
  leaked=$(grep -rnF "$path" "$library/cmake" "$library/pkgconfig" || true)
  [ -z "$leaked" ] || failed "the package names a folder of this machine: $leaked"
done

# --- the example, as its README says
cp -r "$checkout/examples/postprocess" example
cmake -S example -B example/build -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" >configure.log 2>&1 || { cat configure.log; failed 'the example is configured'; }
grep -qE -e '-W(all|error|extra)|-fsanitize' example/build/compile_commands.json &&
  failed "the example is compiled with our flags: $(cat example/build/compile_commands.json)"
cmake --build example/build >build.log 2>&1 || { cat build.log; failed 'the example is built'; }
awk -f example/make_contacts.awk >contacts.csv
example/build/postprocess contacts.csv results >printed || failed 'the example runs'

[ "$(wc -l <printed)" = 5 ] || failed "five steps are printed: $(cat printed)"
head -n 1 results/worn_liner.stl | grep -q '^solid' || failed 'the mesh is STL'
# The lifter is 2.155e-3 m2 (a trapezoid of 40 and 69.2 mm, 40 mm high, less the plate's arc below
# it), of which a fifth is to go: 4.31e-4 m2 between the profiles.
awk -F, '/^[-0-9]/ { n += 1; x[n] = $1; y[n] = $2; if (FILENAME ~ /new_/) split_at = n }
  END { for (i = 2; i <= split_at; ++i) area += (x[i] - x[i-1]) * (y[i] + y[i-1]) / 2
        for (i = split_at + 2; i <= n; ++i) area -= (x[i] - x[i-1]) * (y[i] + y[i-1]) / 2
        print area; exit !(area > 4.22e-4 && area < 4.40e-4) }' \
  results/new_profile.csv results/worn_profile.csv >area || failed "a fifth of the lifter goes, not $(cat area) m2"
# Archard: a fifth of that, 8.62e-5 m2, goes in t with  k W / (12 lifters 0.12 m 4 s) t = 8.62e-5 m2.
awk -F, '/^[0-9]/ { work += $6 * $7 * 0.01 } END { print 8.62e-5 * 12 * 0.12 * 4 / (1e-12 * work) / 3600 }' \
  contacts.csv >first_step
awk 'NR == FNR { by_hand = $1; next } { exit !($1 > 0.98 * by_hand && $1 < 1.02 * by_hand) }' \
  first_step printed || failed "the first step takes $(cat first_step) h by hand, and: $(cat printed)"

sed 1s/slip_speed_m_per_s/slip/ contacts.csv >without_slip.csv
example/build/postprocess without_slip.csv nothing 2>refusal && failed 'a missing column is refused'
grep -q 'without_slip.csv:1: no column `slip_speed_m_per_s`' refusal || failed "the column is named: $(cat refusal)"
[ ! -e nothing ] || failed 'a refused table leaves nothing'

# --- pkg-config
export PKG_CONFIG_PATH="$library/pkgconfig"
printf '#include <cstdio>\n#include "mill/base/version.h"\nint main() { std::puts(millwear::program_version().c_str()); }\n' >version.cpp
# shellcheck disable=SC2046  # the flags are meant to be split
c++ -std=c++20 version.cpp $(pkg-config --cflags --libs millwear) -o version || failed 'pkg-config says how to link'
[ "$(./version | cut -d' ' -f 2)" = "$(pkg-config --modversion millwear)" ] || failed 'the linked library has the version that pkg-config tells'

# --- what find_package refuses
mkdir asking
cat >asking/CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(asking LANGUAGES CXX)
find_package(millwear ${WANTED_VERSION} REQUIRED COMPONENTS ${WANTED})
END
ask() {  # version, components, further options; what CMake answers is in `answer`, on one line
  version=$1 wanted=$2
  shift 2
  cmake -S asking -B asking/build -DCMAKE_PREFIX_PATH="$prefix" -DWANTED_VERSION="$version" \
    -DWANTED="$wanted" "$@" >raw_answer 2>&1 && asked=found || asked=refused
  tr -s ' \n' ' ' <raw_answer >answer
}
answers() { [ "$asked" = "$1" ] && grep -qF "$2" answer || failed "$3: $(cat raw_answer)"; }
ask 0.1 'wear;recorder'
answers refused 'millwear has no component "recorder"; it has mill, wear and meshgen' 'an unknown component is refused'
ask 2.0 wear
answers refused 'compatible with requested version "2.0"' 'another version is refused'
ask 0.1 'wear;meshgen' -DGMSH_INCLUDE_DIR=
answers refused 'install libgmsh-dev' 'a missing gmsh is named'
ask 0.1 wear -DCMAKE_DISABLE_FIND_PACKAGE_Gmsh=ON
answers found 'Generating done' 'wear alone needs no gmsh'
