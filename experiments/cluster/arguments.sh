# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=sh
# Arguments of parallel.sh and submit.sh, which read this file.

# refuse NAME PROBLEM REMEDY: on standard error; ends with 2.
refuse() {
  echo "$1: $2; $3" >&2
  exit 2
}

# check_arguments USAGE ARGUMENT ..: a plan, its name or a file that can be read, a folder, and two numbers from 1.
check_arguments() {
  usage=$1 name=${1%% *}
  shift
  [ $# -ge 4 ] || { echo "usage: $usage" >&2; exit 2; }
  case $1 in
    */* | *.json) [ -r "$1" ] || refuse "$name" "$1: the plan cannot be read" "check the name" ;;
  esac
  for number in "$3" "$4"; do
    case $number in
      '' | *[!0-9]* | 0*) refuse "$name" "'$number' is no number from 1" "usage: $usage" ;;
    esac
  done
}
