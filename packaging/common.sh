# What packaging/try, packaging/test and .ci/run share; to be sourced by bash.

readonly project_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly apt_log=$project_dir/build/packages.log

say() { printf '\n== %s\n' "$*"; }

fail() {
  printf '\n%s: error: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# missing_packages [program|tests|packages|checks|windows]: the packages of debian-packages.txt that are not installed, for
# the program alone, for its tests (if nothing is said), for packaging/package or for packaging/check too; or for the
# program and for packaging/windows. One that another package provides is there, as npm in the nodejs of other archives.
missing_packages() {
  local wanted end
  case ${1:-tests} in
  program) end='/^# Tests/,$d' ;;
  tests) end='/^# Packages/,$d' ;;
  packages) end='/^# Checks/,$d' ;;
  windows) end='/^# Tests/,/^# Windows/d' ;;
  *) end='/^# Windows/,$d' ;;
  esac
  local VERSION_ID=12
  [[ -r /etc/os-release ]] && . /etc/os-release
  mapfile -t wanted < <(sed -e "$end" "$project_dir/packaging/debian-packages.txt" | sed 's/#.*//' |
    awk -v here="[$VERSION_ID]" 'NF && (!$2 || $2 == here) { print $1 }')
  comm -23 <(printf '%s\n' "${wanted[@]}" | sort -u) \
    <(dpkg-query -W -f '${db:Status-Status} ${Package} ${Provides}\n' |
      awk '$1 == "installed" { gsub(/,/, ""); for (i = 2; i <= NF; ++i) print $i }' | sort -u)
}

check_system() {
  local ID='an unknown system' ID_LIKE='' VERSION_ID='' PRETTY_NAME=''
  [[ -r /etc/os-release ]] && . /etc/os-release
  if ! command -v dpkg-query >/dev/null || [[ " $ID $ID_LIKE " != *' debian '* ]]; then
    fail "this is ${PRETTY_NAME:-$ID}; the set-up is for Debian 12 and 13. Elsewhere, install what" \
      "packaging/debian-packages.txt names and run: cmake --preset program && cmake --build --preset program"
  fi
  if [[ $ID != debian || ! $VERSION_ID =~ ^1[23]$ ]]; then
    echo "Note: this is ${PRETTY_NAME:-$ID}; the package names are those of Debian 12 and 13."
  fi
}

as_root() {
  if ((EUID == 0)); then
    "$@"
  else
    sudo "$@"
  fi
}

# One line that counts packages as dpkg unpacks and configures them; the whole output goes to the log.
count_packages() {
  local every=25
  [[ -t 1 ]] && every=1
  awk -v log_file="$apt_log" -v every="$every" '
    { print >> log_file }
    / newly installed/ { total = $3 }
    /^(Unpacking|Setting up) / {
      step[$1]++
      if (every == 1) printf "\r  unpacked %d, set up %d of %d ", step["Unpacking"], step["Setting"], total
      else if (step[$1] % every == 0) printf "  %s %d of %d\n", $1 == "Setting" ? "set up" : "unpacked", step[$1], total
      fflush()
    }
    END { if (every == 1) print "" }'
}

# install_packages [program|tests|packages|checks|windows]: installs what is missing_packages; asks nothing and does nothing where all is there.
install_packages() {
  check_system
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if ((${#missing[@]} == 0)); then
    say 'Packages: all there'
    return
  fi
  say "Packages: installing ${missing[*]}"
  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    fail "packages can only be installed as root: run this as root, install sudo, or have root run:" \
      "apt-get install --no-install-recommends ${missing[*]}"
  fi
  mkdir -p "$project_dir/build"
  : >"$apt_log"
  local apt=(env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -q -y --no-install-recommends -o DPkg::Lock::Timeout=300
    -o Dpkg::Use-Pty=0)
  # Without the thousands of disk syncs of dpkg the set-up takes half the time.
  if ! { as_root "${apt[@]}" update && as_root "${apt[@]}" install eatmydata; } >>"$apt_log" 2>&1 ||
    ! as_root eatmydata "${apt[@]}" install "${missing[@]}" 2>&1 | count_packages; then
    tail -n 20 "$apt_log" >&2
    fail "the packages could not be installed; the whole output is in $apt_log"
  fi
}

# build PRESET TARGET...: configures and builds; ninja shows the progress.
build() {
  local preset=$1
  shift
  cd "$project_dir"
  mkdir -p build
  say "Configuring ($preset)"
  cmake --preset "$preset" >build/configure.log 2>&1 || {
    tail -n 40 build/configure.log >&2
    fail "the build could not be configured; the whole output is in $project_dir/build/configure.log"
  }
  say "Building ($preset)"
  cmake --build --preset "$preset" --target "$@"
}

# run_tests NAME TARGET SELECTION...: builds TARGET of preset test and runs the tests that SELECTION names, as options of
# ctest. Where one fails, ends with what failed and how to run it again.
run_tests() {
  local name=$1 target=$2 results=$project_dir/build/test/results
  shift 2
  cmake --build --preset test --target "$target"
  say "Testing: $name"
  mkdir -p "$results"
  if ! ctest --preset test --parallel "$(nproc)" --no-label-summary --output-junit "$results/ctest-$name.xml" "$@"; then
    say 'What failed'
    tests/summary.py build/test || true
    fail "tests failed"
  fi
}

# test_everything [COMMAND...]: builds and tests, cheapest first; COMMAND is run between fast and slow tests.
test_everything() {
  build test layering_test
  rm -rf build/test/results
  run_tests layering layering_test -L '^layering$'
  run_tests fast fast_tests -L '^fast$' -LE '^layering$'
  "$@"
  run_tests slow all -LE '^fast$'
  say 'All tests passed'
  tests/summary.py build/test 10
}

# install_linuxcnc: the package linuxcnc-uspace (some 80 MB) where it is missing.
install_linuxcnc() {
  if ! command -v linuxcnc >/dev/null; then
    say 'Packages: installing linuxcnc-uspace'
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends -o DPkg::Lock::Timeout=300 install linuxcnc-uspace ||
      fail "linuxcnc-uspace could not be installed; run 'apt-get update' and try again"
  fi
}
