#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Pictures of the window: every tab, the sheets and the welcome page, at 1280x800 and 2560x1440, dark and light.
# Usage: tests/viewer/screenshots.sh [FOLDER]     (default ./screenshots; needs build/release/polariscope, Xvfb, xdotool)
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
exec python3 "$root/tests/viewer/screenshots.py" "${BUILD:-$root/build}/release/polariscope" "${1-screenshots}"
