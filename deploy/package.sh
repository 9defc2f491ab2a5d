#!/usr/bin/env bash
# Makes the Debian package from build/release and web/dist (deploy/build.sh makes both), and beside it the list of what is
# in it (SBOM).
# usage: deploy/package.sh [--try]      --try, as root: installs the package, starts what it holds, and purges it again
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

make_package() {
  run_or_fail "the package could not be made" "read the message above; dpkg-dev and file must be installed" \
    cpack --config "$root/build/release/CPackConfig.cmake" -B "$root/build/package" >&2
  run_or_fail "the list of what is in the package could not be made" "read the message above" \
    "$root/deploy/sbom.py" "$root/build/release/floeplan" "$root/build/package/floeplan.cdx.json" >&2
  find "$root/build/package" -maxdepth 1 -name 'floeplan_*.deb' -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d ' ' -f 2-
}

try_package() {
  local package=$1
  [[ $(id -u) -eq 0 ]] || fail "a package is tried by installing it" "run this as root, in a container or a virtual machine"
  if dpkg-query -W floeplan >/dev/null 2>&1; then
    fail "floeplan is installed here, and trying would purge it" "try the package on another machine"
  fi
  say "installing $package"
  run_or_fail "the package could not be installed" "apt-get install -f names what is missing" dpkg -i "$package"
  floeplan --version
  [[ -f /usr/share/man/man1/floeplan-plan.1.gz && -f /usr/share/bash-completion/completions/floeplan ]] ||
    fail "the package lacks man pages or completions" "look at what cmake/packaging.cmake installs"
  [[ -f /usr/share/floeplan/web/guide/index.html ]] || fail "the package lacks the guide" "deploy/build.sh builds it"
  local store
  store=$(mktemp -d)
  floeplan --data "$store" datasets
  FLOEPLAN=/usr/bin/floeplan /usr/share/floeplan/backup.sh "$store" "$store/backups"
  rm -r "$store"
  say "purging it"
  run_or_fail "the package could not be purged" "read the message above" dpkg --purge floeplan
  local left
  left=$(find /usr/bin/floeplan /usr/share/floeplan /etc/default/floeplan /etc/default/floeplan-worker /lib/systemd/system/floeplan.service 2>/dev/null || true)
  [[ -z $left ]] || fail "the package left files behind" "see: $left"
  say "installed, tried and purged"
}

main() {
  local package
  case ${1-} in
    '' | --try) ;;
    *) fail "unknown option $1" "use: deploy/package.sh [--try]" ;;
  esac
  package=$(make_package)
  [[ -n $package ]] || fail "no package was made" "read the messages above"
  say "$package"
  if [[ ${1-} == --try ]]; then try_package "$package"; fi
}

main "$@"
