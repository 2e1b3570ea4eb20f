#!/bin/sh
# SPDX-License-Identifier: MIT OR Apache-2.0
# Runs a command inside a chroot made by provision_blender.sh, with the repository at /repo.
#
#   scripts/enter_chroot.sh ROOT COMMAND [ARGUMENT ...]
#
# Mounts and processes live in namespaces of their own: when the command ends, nothing of either is left, and deleting
# the chroot's folder can touch no file outside of it.
set -eu

[ $# -ge 2 ] || { echo "usage: $0 ROOT COMMAND [ARGUMENT ...]" >&2; exit 2; }
export BOXMORPH_ROOT=$1
BOXMORPH_REPO=$(cd "$(dirname "$0")/.." && pwd)
export BOXMORPH_REPO
shift
exec unshare --mount --pid --fork --kill-child sh -c '
    set -e
    mkdir -p "$BOXMORPH_ROOT/repo" "$BOXMORPH_ROOT/dev/shm"
    mount -t proc proc "$BOXMORPH_ROOT/proc"
    mount -t tmpfs -o mode=1777 tmpfs "$BOXMORPH_ROOT/dev/shm"
    mount --bind "$BOXMORPH_REPO" "$BOXMORPH_ROOT/repo"
    root=$BOXMORPH_ROOT
    unset BOXMORPH_ROOT BOXMORPH_REPO
    exec chroot "$root" /usr/bin/env PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 "$@"' sh "$@"
