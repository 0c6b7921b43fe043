#!/usr/bin/env bash
# What the tests of the command line share. Sourced with the path of shadesim: a folder of its own to work in,
# and counts of what passed and failed.
set -uo pipefail
shadesim=$1  # absolute
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
cd -- "$work" || exit 1
passed=0
failed=0

check() {  # check NAME COMMAND...: the command must succeed
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED: $name"
  fi
}

# refuse PATTERN ARGS...: exit status 2, nothing on stdout, one line on stderr that matches.
refuse() {
  local pattern=$1
  shift
  "$shadesim" "$@" >stdout 2>stderr
  local status=$?
  check "'$*' exits with 2, not $status" test "$status" -eq 2
  check "'$*' prints nothing on stdout" test ! -s stdout
  check "'$*' prints one line: $(cat stderr)" test "$(wc -l <stderr)" -eq 1
  check "'$*' says $pattern: $(cat stderr)" grep -qE -- "$pattern" stderr
}

accept() { check "'$*' succeeds" "$shadesim" "$@" --quiet; }

has_keys() {  # has_keys FILE KEY...
  local file=$1 key
  shift
  for key in "$@"; do check "$file has $key" grep -q "^  \"$key\":" "$file"; done
}

summary() {  # summary LEAST: the exit status; so many checks must have run
  echo "$passed passed, $failed failed"
  test "$failed" -eq 0 && test "$passed" -gt "$1"
}
