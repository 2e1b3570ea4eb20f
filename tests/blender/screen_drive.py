# SPDX-License-Identifier: MIT OR Apache-2.0
"""Mouse, keyboard and eyes on a virtual screen with Blender on it. Runs inside the chroot."""

import json
import os
import subprocess
import time
from pathlib import Path

#: As high as a small laptop's, on which nothing of the panel should need scrolling.
WIDTH, HEIGHT = 960, 768


class Screen:
    """An X server with Blender filling it. Use as a context manager."""

    def __init__(self, folder, arguments):
        self.folder = Path(folder)
        self.arguments = arguments
        self.count = 0

    def __enter__(self):
        channel = self.folder / "channel"
        runtime = self.folder / "runtime"
        channel.mkdir()
        runtime.mkdir(mode=0o700)
        self.channel = channel
        read, write = os.pipe()
        screen = f"{WIDTH}x{HEIGHT}x24"
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", screen, "-nolisten", "tcp"],
            pass_fds=[write],
            stderr=subprocess.DEVNULL,
        )
        os.close(write)
        with os.fdopen(read) as pipe:
            display = pipe.readline().strip()
        self.environment = dict(
            os.environ,
            DISPLAY=f":{display}",
            HOME=str(self.folder),
            XDG_RUNTIME_DIR=str(runtime),
            LIBGL_ALWAYS_SOFTWARE="1",
            BOXMORPH_CHANNEL=str(channel),
        )
        state = str(Path(__file__).with_name("screen_state.py"))
        self.log = open(self.folder / "blender.log", "w", encoding="utf-8")
        self.blender = subprocess.Popen(
            ["blender", "-p", "0", "0", str(WIDTH), str(HEIGHT), *self.arguments, "--python", state],
            env=self.environment,
            stdout=self.log,
            stderr=subprocess.STDOUT,
        )
        self.wait(lambda: self.ask("True"), 300, "Blender on the screen")
        return self

    def __exit__(self, *_):
        for process in (self.blender, self.server):
            process.terminate()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
        self.log.close()

    def ask(self, code, timeout=120):
        """Evaluate `code` inside Blender; return its value. Raises RuntimeError with Blender's traceback."""
        self.count += 1
        path = self.channel / "ask.json"
        (self.channel / "ask.new").write_text(json.dumps({"id": self.count, "code": code}), encoding="utf-8")
        os.replace(self.channel / "ask.new", path)
        until = time.monotonic() + timeout
        while time.monotonic() < until:
            if self.blender.poll() is not None:
                raise RuntimeError(f"Blender ended with exit code {self.blender.returncode}")
            try:
                answer = json.loads((self.channel / "answer.json").read_text(encoding="utf-8"))
            except (OSError, ValueError):
                answer = {}
            if answer.get("id") == self.count:
                if "error" in answer:
                    raise RuntimeError(answer["error"])
                return answer["value"]
            time.sleep(0.03)
        raise RuntimeError(f"Blender did not answer within {timeout} s")

    def wait(self, condition, seconds, what):
        """Poll `condition` until it is true; return its value. Raises RuntimeError after `seconds`."""
        until = time.monotonic() + seconds
        error = None
        while time.monotonic() < until:
            try:
                value = condition()
                if value:
                    return value
            except RuntimeError as failure:
                error = failure
                if self.blender.poll() is not None:
                    raise
            time.sleep(0.1)
        raise RuntimeError(f"waited {seconds} s for: {what}. {error or ''}")

    def quit(self):
        """Quit Blender by its operator; return the exit code, or None if it hangs."""
        try:
            self.ask(
                "bpy.app.timers.register(lambda: bpy.ops.wm.quit_blender() and None, first_interval=0.2)"
            )
            return self.blender.wait(60)
        except subprocess.TimeoutExpired:
            return None

    def shot(self, path):
        """Save a screenshot."""
        time.sleep(0.4)
        subprocess.run(["import", "-window", "root", str(path)], env=self.environment, check=True)

    def key(self, name):
        """Press a key, as xdotool names it."""
        self._xdotool("key", name)

    def press(self, button):
        """Press and release a button of the mouse where it is; 4 and 5 are the wheel."""
        self._xdotool("click", button)

    def move(self, x, y):
        """Move the mouse there, with the small steps that make Blender notice."""
        self._xdotool("mousemove", x, y)
        time.sleep(0.12)
        self._xdotool("mousemove_relative", 1, 0)
        time.sleep(0.12)

    def click(self, x, y):
        """Leave what is under the mouse, come back and press the left button."""
        self.move(WIDTH // 3, HEIGHT // 2)
        self.move(x, y)
        self._xdotool("mousedown", 1)
        time.sleep(0.1)
        self._xdotool("mouseup", 1)
        time.sleep(0.2)

    def drag(self, x, y, pixels):
        """Press the left button, move so many pixels to the left and let go."""
        self.move(x, y)
        self._xdotool("mousedown", 1)
        time.sleep(0.2)
        # Small steps from where the pointer is: Blender moves it back and forth while a slider is dragged.
        for _ in range(0, pixels, 5):
            self._xdotool("mousemove_relative", "--", -5, 0)
            time.sleep(0.05)
        self._xdotool("mouseup", 1)
        time.sleep(0.3)

    def type_into(self, x, y, text, *keys, shot=None):
        """Replace the text of the field there, press `keys`, save a screenshot if asked, and press Return."""
        self.move(x, y)
        self._xdotool("click", "--repeat", 2, "--delay", 80, 1)
        time.sleep(0.3)
        self.key("ctrl+a")
        self._xdotool("type", "--delay", 40, text)
        for key in keys:
            time.sleep(0.3)
            self.key(key)
        if shot:
            self.shot(shot)
        self.key("Return")
        time.sleep(0.3)

    def under(self, x, y):
        """Return what Blender copies with the mouse there: a button's Python call, a field's text, or ""."""
        self.ask("setattr(bpy.context.window_manager, 'clipboard', '')")
        self.move(x, y)
        self.key("ctrl+c")
        time.sleep(0.25)
        return self.ask("bpy.context.window_manager.clipboard")

    def _xdotool(self, *arguments):
        subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, check=True)
