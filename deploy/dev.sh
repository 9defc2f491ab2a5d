#!/usr/bin/env bash
# For working on Floeplan: builds the dev preset (only what changed), serves a store with the demonstration data, and
# serves the browser client with reload. When a source of the program changes it is built again and the server restarted;
# when a source of the client changes the browser shows it at once. Ctrl-C ends all of it.
# usage: deploy/dev.sh [--data STORE]      open http://127.0.0.1:5173
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly listen=127.0.0.1:8080 # what web/vite.config.ts hands the API on to
readonly floeplan=$root/build/dev/floeplan
store=$root/build/dev-store
server=
client=

build() {
  if [[ ! -f $root/build/dev/build.ninja ]]; then cmake -S "$root" --preset dev || return; fi
  cmake --build "$root/build/dev" -j "$(build_jobs)" --target floeplan
}

fill_store() {
  if [[ -d $store ]]; then return; fi
  say "filling $store with the demonstration data"
  "$floeplan" demo "$root/build/dev-demo" >/dev/null
  mkdir -p "$store"
  "$floeplan" --data "$store" ingest "$root"/build/dev-demo/disko-*
}

start_server() {
  "$floeplan" --data "$store" serve --listen "$listen" --web "$root/web/dist" &
  server=$!
}

stop_server() {
  if [[ -z $server ]]; then return; fi
  kill "$server" 2>/dev/null || true
  wait "$server" 2>/dev/null || true
  server=
}

end() {
  trap - EXIT INT TERM
  stop_server
  if [[ -n $client ]]; then kill "$client" 2>/dev/null || true; fi
}

# changed_since FILE: whether a source of the program is newer.
changed_since() {
  [[ -n $(find "$root"/{engine,storage,api,server,cmake,CMakeLists.txt} -newer "$1" \
    \( -name '*.[ch]pp' -o -name '*.json' -o -name '*.cmake' -o -name CMakeLists.txt \) -print -quit) ]]
}

main() {
  case ${1-} in
    '') ;;
    --data)
      [[ -n ${2-} ]] || fail "--data needs a folder" "for example --data ~/floeplan"
      store=$2
      ;;
    *) fail "unknown option $1" "use: deploy/dev.sh [--data STORE]" ;;
  esac
  "$root/deploy/install-deps"
  use_node
  local stamp=$root/build/dev-built
  mkdir -p "$root/build"
  touch "$stamp"
  build || fail "the program does not build" "read the first error above"
  fill_store
  if [[ ! -d $root/web/node_modules ]]; then npm --prefix "$root/web" ci --no-audit --no-fund --loglevel=error; fi
  trap end EXIT
  trap 'exit 130' INT
  trap 'exit 143' TERM
  start_server
  # Not by npm, which would leave Vite running when it is ended.
  (cd "$root/web" && exec node_modules/.bin/vite --host 127.0.0.1 --port 5173 --strictPort) &
  client=$!
  while kill -0 "$client" 2>/dev/null; do
    sleep 1
    if ! changed_since "$stamp"; then continue; fi
    touch "$stamp"
    say "a source changed"
    if build; then
      stop_server
      start_server
    else
      say "the program does not build; the server before it goes on"
    fi
  done
}

main "$@"
