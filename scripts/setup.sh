#!/usr/bin/env bash
# Usage: scripts/setup.sh [TARGET...]
#
# Installs the packages of scripts/packages.txt that are missing, configures build/release when it
# is not configured yet and builds the given CMake targets there, or everything when none is given.
# Works from any folder. The complete output goes to build/packages.log and build/build.log.
set -euo pipefail
CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

readonly tree=build/release
readonly package_log=build/packages.log
readonly build_log=build/build.log

# fail LOG MESSAGE: the end of the log, then the message.
fail() {
  tail -n 40 -- "$1" >&2 || true
  printf '\n%s\nThe complete output is in %s\n' "$2" "$PWD/$1" >&2
  exit 1
}

# Prints the names in scripts/packages.txt that are not installed.
missing_packages() {
  local -a wanted
  local -A installed=()
  local line name status
  while read -r line; do
    line=${line%%#*}
    # Unquoted on purpose: this splits at blanks, so empty lines add nothing.
    # shellcheck disable=SC2206
    wanted+=($line)
  done <scripts/packages.txt
  # dpkg-query fails when it knows nothing of one of the names; that name is then simply not listed.
  while read -r name status; do
    [[ $status != installed ]] || installed[$name]=1
  done < <(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)
  for name in "${wanted[@]}"; do
    [[ -n ${installed[$name]:-} ]] || printf '%s\n' "$name"
  done
}

install_packages() {
  local -a missing as_root=()
  local -a install=(apt-get install -y --no-install-recommends)
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0

  if ((EUID != 0)); then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
      as_root=(sudo -n)
    else
      {
        echo "Packages are missing. Please install them and run this again:"
        echo
        echo "  sudo apt-get update && sudo ${install[*]} ${missing[*]}"
      } >&2
      exit 1
    fi
  fi

  echo "Installing ${#missing[@]} packages, which takes a few minutes: ${missing[*]}"
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  # An unreachable third-party source makes the update fail although every package can be had, so
  # the installation decides.
  "${as_root[@]}" apt-get update >"$package_log" 2>&1 ||
    echo "The package lists could not all be updated; trying the installation anyway."
  "${as_root[@]}" "${install[@]}" -o DPkg::Lock::Timeout=300 "${missing[@]}" \
    >>"$package_log" 2>&1 </dev/null || fail "$package_log" "The packages could not be installed."
}

check_other_system() {
  local tool
  echo "This system has no Debian packages, so they are not checked. The build needs the" \
    "equivalents of those in scripts/packages.txt, in the versions of Debian 12 or newer." >&2
  for tool in cmake ninja verilator pkg-config; do
    if ! command -v "$tool" >/dev/null; then
      echo "$tool is missing." >&2
      exit 1
    fi
  done
}

# Turns ninja's status lines into one line that counts, or into a line for every tenth of the way
# when nobody watches.
show_progress() {
  local line tenth shown=0
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$build_log"
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] || continue
    if [[ -t 1 ]]; then
      printf '\rBuilding: step %d of %d ' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}"
      shown=1
    else
      tenth=$((10 * BASH_REMATCH[1] / BASH_REMATCH[2]))
      ((tenth == shown)) || printf 'Building: %d %%\n' $((10 * tenth))
      shown=$tenth
    fi
  done
  if [[ -t 1 ]] && ((shown)); then echo; fi
}

configure() {
  echo "Configuring $tree"
  cmake --preset release >>"$build_log" 2>&1 ||
    fail "$build_log" "The build could not be configured."
}

build() {
  local -a targets=()
  (($# == 0)) || targets=(--target "$@")
  cmake --build "$tree" "${targets[@]}" 2>&1 | show_progress ||
    fail "$build_log" "The build failed."
}

mkdir -p build
if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then
  install_packages
else
  check_other_system
fi

# Two builds at once in the same tree would overwrite each other's files.
exec {lock}>build/.lock
if ! flock -n "$lock"; then
  echo "Waiting for another build in this tree"
  flock "$lock"
fi
: >"$build_log"
# From then on ninja configures again by itself whenever a CMake file changes.
[[ -e $tree/build.ninja ]] || configure
build "$@"
