# shellcheck shell=bash
# What the examples in shell share; to be sourced. Needs curl.
# The variable FLOEPLAN_TOKEN holds the token where the server wants one; other processes do not see it in a command line.
set -euo pipefail

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$1" >&2
  exit 1
}

# ask ADDRESS [CURL OPTION...]: the answer's body; of one that the server refuses, its reasons, and ends.
ask() {
  local address=$1 answer status
  shift
  answer=$(curl --silent --show-error --retry 5 --max-time 3600 --write-out '\n%{http_code}' \
    --header @<(if [[ -n ${FLOEPLAN_TOKEN-} ]]; then echo "Authorization: Bearer $FLOEPLAN_TOKEN"; fi) \
    "$@" "$address") || fail "$address could not be asked"
  status=${answer##*$'\n'}
  if ((status >= 400)); then fail "${answer%$'\n'*}"; fi
  printf '%s\n' "${answer%$'\n'*}"
}

# text_of NAME: the first member of this name in the JSON on standard input, if it is a text.
text_of() {
  grep -o "\"$1\": *\"[^\"]*\"" | head -n 1 | sed 's/.*: *"//; s/"$//' || true
}

# wait_for SERVER JOB: prints how the job ended. Each question is answered at the next change, or after 20 seconds.
wait_for() {
  local status=accepted
  while [[ $status == accepted || $status == running ]]; do
    status=$(ask "$1/jobs/$2" --header 'Prefer: wait=20' | text_of status)
  done
  echo "$status"
}
