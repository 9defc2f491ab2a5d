# shellcheck shell=bash
# What the scripts of this folder share. To be sourced; sets `root`, the top of the source tree.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

readonly node_minimum=20.19.0 # what the tools of web/ need

say() { printf '%s\n' "== $*"; }

# fail WHAT WHAT_TO_DO
fail() {
  printf 'floeplan: %s; %s\n' "$1" "$2" >&2
  exit 1
}

# run_or_fail WHAT WHAT_TO_DO COMMAND...
run_or_fail() {
  local what=$1 advice=$2
  shift 2
  "$@" || fail "$what" "$advice"
}

# The Node.js that install-deps put below build/ goes first, when it had to. Node.js brings certificate authorities of its
# own; those that the system trusts are added, or npm would fail behind a proxy that has one.
use_node() {
  local system_authorities=/etc/ssl/certs/ca-certificates.crt
  if [[ -e $system_authorities ]]; then export NODE_EXTRA_CA_CERTS=${NODE_EXTRA_CA_CERTS:-$system_authorities}; fi
  local own=$root/build/node/node_modules/node/bin
  if [[ -x $own/node ]]; then PATH=$own:$PATH; fi
}

node_is_recent() {
  command -v node >/dev/null || return 1
  local found
  found=$(node --version)
  [[ $(printf '%s\n' "$node_minimum" "${found#v}" | sort -V | head -n 1) == "$node_minimum" ]]
}

# How many compilers fit at once: one for each processor and for each 1.5 GB of memory.
build_jobs() {
  local processors memory_kb
  processors=$(nproc)
  memory_kb=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo)
  local fit=$((memory_kb / 1500000))
  echo $((fit < 1 ? 1 : (fit < processors ? fit : processors)))
}
