# SPDX-License-Identifier: Apache-2.0
"""Takes the pictures of screenshots.sh. Usage: screenshots.py PROGRAM FOLDER"""

import sys
import time
from pathlib import Path

from window import SCENES, Display, Window, missing_tools

SIZES = [(1280, 800), (2560, 1440)]
THEMES = ["dark", "light"]
SCENE = SCENES / "paper-calcite-unpolarized.yaml"
PIXEL = (256, 220)
MAPS = {"color": "1", "dop": "3", "azimuth": "5"}
RENDER_SHARE = 0.999  # the whole picture


def take(program, folder, size, theme):
    width, height = size
    display = Display(width, height)
    name = f"{width}x{height}-{theme}"

    def shoot(window, what):
        window.settle()
        window.screenshot(folder / f"{name}-{what}.png")

    try:
        common = ["--size", f"{width}x{height}", "--theme", theme]
        empty = Window(program, display, *common)
        shoot(empty, "welcome")
        empty.key("F1")
        shoot(empty, "help")
        empty.end()

        window = Window(program, display, SCENE, *common)
        window.wait_for(lambda w: w.state["done"] > RENDER_SHARE, "a part of the picture")
        for quantity, key in MAPS.items():
            window.key(key)
            shoot(window, f"map-{quantity}")
        window.key("3")
        window.click_pixel(*PIXEL)
        window.move(width / 2, 5)
        tabs = [widget for widget in window.state["widgets"] if widget.startswith("tab ")]
        for tab in tabs:
            window.click(tab)
            window.move(width / 2, 5)
            shoot(window, tab.replace("tab ", "tab-").lower().replace(" ", "-"))
        window.key("ctrl+l")
        shoot(window, "log")
        window.key("ctrl+l", "ctrl+shift+p")
        shoot(window, "commands")
        window.key("Escape")
        window.key("Tab")
        shoot(window, "picture-alone")
        window.key("Tab", "i")
        window.wait_for(lambda w: w.state["done"] > RENDER_SHARE, "the twin")
        time.sleep(2.0)  # the difference follows the finished picture row by row
        shoot(window, "difference")
        window.key("ctrl+shift+a")
        shoot(window, "save-as")
        window.end()
    finally:
        display.close()


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    if missing := missing_tools():
        sys.exit(f"screenshots.sh: not installed: {', '.join(missing)}; tests/run.sh installs them")
    folder = Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for size in SIZES:
        for theme in THEMES:
            take(Path(sys.argv[1]).resolve(), folder.resolve(), size, theme)
    print(f"{len(list(folder.glob('*.png')))} pictures in {folder}")


if __name__ == "__main__":
    main()
