#!/usr/bin/env bash
# Builds the program (build/release/floeplan) and the browser client (web/dist); only what changed since the last time.
# usage: deploy/build.sh [--with-tests]
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build_program() {
  if [[ ! -f $root/build/release/build.ninja ]]; then
    run_or_fail "cmake could not configure the build" "run deploy/install-deps; if that is done, read the message above" \
      cmake -S "$root" --preset release
  fi
  run_or_fail "the program does not compile" "read the first error above; after an update of Debian remove build/release and try again" \
    cmake --build "$root/build/release" -j "$(build_jobs)" "$@"
}

# Installs what the lock file names, unless exactly that is installed.
install_web_packages() {
  local stamp=$root/web/node_modules/.installed-lock
  if [[ -f $stamp ]] && cmp -s "$stamp" "$root/web/package-lock.json"; then return; fi
  run_or_fail "npm could not install the packages of web/" "check the network and npm's registry (npm config get registry)" \
    npm --prefix "$root/web" ci --no-audit --no-fund --loglevel=error
  cp "$root/web/package-lock.json" "$stamp"
}

web_is_built() {
  [[ -f $root/web/dist/index.html ]] || return 1
  local newer
  newer=$(find "$root/web" "$root/SECURITY.md" \( -name node_modules -o -name dist -o -name tests \) -prune -o \
    -type f -newer "$root/web/dist/index.html" -print -quit)
  [[ -z $newer ]]
}

build_web() {
  [[ -f $root/web/package.json ]] || fail "web/package.json is missing" "get a complete source tree"
  install_web_packages
  if web_is_built; then return; fi
  run_or_fail "the browser client does not build" "read the first error above" npm --prefix "$root/web" run build
}

main() {
  local targets=(--target floeplan)
  case ${1-} in
    '') ;;
    --with-tests) targets=() ;;
    *) fail "unknown option $1" "use: deploy/build.sh [--with-tests]" ;;
  esac
  use_node
  say "building the program"
  build_program "${targets[@]}"
  say "building the browser client"
  build_web
}

main "$@"
