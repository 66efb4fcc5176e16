#!/usr/bin/env python3
"""A person at the window, played with real mouse events on a virtual screen: starts, takes instruments,
cuts, turns, draws the iso level, opens another organ, saves and reloads the scene, closes.

    window_test.py PROGRAM FOLDER        pictures of each stage are left in FOLDER
"""
import os
import queue
import shutil
import struct
import subprocess
import sys
import threading
import time
import unittest
import zlib
from pathlib import Path

PROGRAM, FOLDER = sys.argv[1], Path(sys.argv[2]).resolve()
WIDTH, HEIGHT = 1280, 1024


class Screen:
    """A virtual screen of its own."""

    def __init__(self):
        for _ in range(5):
            number = self.start()
            if number:
                break
        else:
            raise AssertionError("Xvfb does not start")
        self.environment = {**os.environ, "DISPLAY": ":" + number,
                            "QT_QPA_PLATFORM": "xcb", "XDG_CONFIG_HOME": str(FOLDER / "config"),
                            "XDG_RUNTIME_DIR": str(FOLDER)}

    def start(self):
        """Number of the display; nothing when there is none."""
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        number = b""
        while not number.endswith(b"\n"):
            part = os.read(read, 16)
            if not part:
                break
            number += part
        os.close(read)
        if not number.endswith(b"\n"):
            self.process.kill()
            self.process.wait()
            return ""
        return number.decode().strip()

    def do(self, *args):
        subprocess.run(["xdotool", *map(str, args)], env=self.environment, timeout=30, check=True)

    def move(self, x, y):
        self.do("mousemove", int(x), int(y))
        time.sleep(0.03)

    def click(self, x, y, button=1):
        self.move(x, y)
        self.do("click", button)
        time.sleep(0.2)

    def drag(self, start, end, button=1, steps=16):
        self.move(*start)
        self.do("mousedown", button)
        time.sleep(0.1)
        for i in range(1, steps + 1):
            self.move(start[0] + (end[0] - start[0]) * i / steps, start[1] + (end[1] - start[1]) * i / steps)
        time.sleep(0.1)
        self.do("mouseup", button)
        time.sleep(0.2)

    def focus(self, title):
        """Without a window manager nobody gives the focus to a dialog, or back when it closes."""
        for _ in range(50):
            windows = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], env=self.environment,
                                     capture_output=True, text=True, timeout=30).stdout.split()
            if windows:
                self.do("windowfocus", windows[-1])
                time.sleep(0.3)
                return
            time.sleep(0.2)
        raise AssertionError(f"there is no window {title}")

    def key(self, *keys):
        for key in keys:
            self.do("key", key)
            time.sleep(0.15)

    def type(self, text):
        self.do("type", "--delay", "20", text)
        time.sleep(0.3)

    def picture(self, name):
        """Rows of RGB bytes; also kept as a PNG."""
        dump = subprocess.run(["xwd", "-silent", "-root"], env=self.environment, capture_output=True, timeout=30,
                              check=True).stdout
        header = struct.unpack(">25I", dump[:100])
        size, width, height, stride, colours = header[0], header[4], header[5], header[12], header[19]
        pixels, step = dump[size + 12 * colours:], header[11] // 8
        rows = []
        for y in range(height):
            row = pixels[y * stride:y * stride + step * width]  # blue, green, red, perhaps a spare byte
            rgb = bytearray(3 * width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::step], row[1::step], row[0::step]
            rows.append(bytes(rgb))

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        (FOLDER / f"{name}.png").write_bytes(
            b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 1)) + chunk(b"IEND", b""))
        return rows

    def close(self):
        self.process.terminate()
        self.process.wait(timeout=20)


def difference(a, b, box):
    """Share of the pixels in box (x0, y0, x1, y1) that differ clearly."""
    x0, y0, x1, y1 = box
    changed = 0
    for y in range(y0, y1, 2):
        p, q = a[y][3 * x0:3 * x1:6], b[y][3 * x0:3 * x1:6]
        changed += sum(abs(m - n) > 12 for m, n in zip(p, q))
    return changed / (((y1 - y0 + 1) // 2) * ((x1 - x0 + 1) // 2))


class Window:
    """The program with its window open, and what it says."""

    def __init__(self, screen, *args, scale="1"):
        environment = {**screen.environment, "QT_SCALE_FACTOR": scale}
        self.process = subprocess.Popen([PROGRAM, "window", "--reports", "--no-help", *args], env=environment,
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=(FOLDER / "complaints.txt").open("a"), text=True)
        self.lines, self.places, self.said = queue.Queue(), {}, []
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        for line in self.process.stdout:
            self.lines.put(line.strip())

    def wait(self, beginning, seconds=60):
        """The next line that begins so."""
        end = time.time() + seconds
        while True:
            try:
                line = self.lines.get(timeout=max(0.01, end - time.time()))
            except queue.Empty:
                complaints = (FOLDER / "complaints.txt").read_text()[-600:]
                raise AssertionError(f"the window (status {self.process.poll()}) did not say {beginning!r}; it said "
                                     f"{self.said[-12:]} and {complaints!r}") from None
            self.said.append(line)
            if line.startswith("place "):
                name, x, y = line[6:].rsplit(" ", 2)
                self.places[name] = (int(x), int(y))
            if line.startswith(beginning):
                return line

    def tell(self, command):
        self.process.stdin.write(command + "\n")
        self.process.stdin.flush()

    def drain(self):
        while not self.lines.empty():
            self.said.append(self.lines.get())

    def quit(self):
        self.process.terminate()
        self.process.wait(timeout=30)
        self.process.stdout.close()
        self.process.stdin.close()


class AtTheWindow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.screen = Screen()

    @classmethod
    def tearDownClass(cls):
        cls.screen.close()

    def test_a_first_operation(self):
        screen = self.screen
        window = Window(screen, "--spacing", "8mm", "--size", "1240x900")
        self.addCleanup(window.quit)
        window.wait("ready")
        organ, scalpel = window.places["organ"], window.places["Scalpel"]
        begin = screen.picture("1_start")

        # As in the thesis: click, handle box, trackball, and a click elsewhere.
        screen.click(*scalpel)
        window.wait("held Scalpel handle-box")
        time.sleep(0.6)
        box = screen.picture("2_handle_box")
        near = (scalpel[0] - 90, scalpel[1] - 120, scalpel[0] + 90, scalpel[1] + 120)
        self.assertGreater(difference(begin, box, near), 0.005)
        screen.click(*scalpel, button=2)
        window.wait("held Scalpel trackball")
        time.sleep(0.6)
        screen.picture("3_trackball")
        screen.click(organ[0] - 60, organ[1] + 260)
        window.wait("held nothing")

        # Directly: over the liver, then down into it.
        screen.drag(scalpel, (organ[0], organ[1] - 40), steps=30)
        window.wait("held Scalpel direct")
        screen.drag((organ[0], organ[1] + 250), (organ[0] - 10, organ[1] + 290), steps=20)
        window.drain()
        removed = [int(line.split()[1]) for line in window.said if line.startswith("removed ")]
        if not removed:  # the wheel brings it nearer and farther
            for button in (4, 5):
                for _ in range(25):
                    screen.do("click", button)
                    time.sleep(0.03)
            removed = [int(window.wait("removed ").split()[1])]
        self.assertGreater(removed[-1], 0)
        time.sleep(0.8)
        cut = screen.picture("4_cut")
        around = (organ[0] - 150, organ[1] - 150, organ[0] + 150, organ[1] + 150)
        self.assertGreater(difference(begin, cut, around), 0.005)

        # Every other instrument in hand, by its key, and back.
        for key, name in (("2", "Hook"), ("3", "Baton"), ("1", "Scalpel")):
            screen.key(key)
            window.wait(f"held {name} direct")
            screen.key("Up", "Left", "shift+Right", "Prior")
        screen.key("Escape")
        window.wait("held nothing")

        # The iso level, on its scale in the scene.
        screen.key("space")
        window.wait("places")
        time.sleep(0.8)
        before = screen.picture("5_whole_view")
        x, y = window.places["iso"]
        screen.drag((x, y), (x, y - 45))
        time.sleep(0.8)
        after = screen.picture("6_iso")
        self.assertGreater(difference(before, after, around), 0.01)

        # The scene into a file and back; then another organ.
        scene = FOLDER / "scene.iv"
        window.tell(f"save-scene {scene}")
        window.wait(f"written {scene}")
        self.assertIn(b"DEF Organ", scene.read_bytes())
        window.tell(f"open {scene}")
        window.wait("report ")
        screen.picture("7_open_scene")
        screen.click(*window.places["open"])
        window.wait("organ scene.iv")
        time.sleep(1.0)
        screen.picture("8_scene_again")

        screen.focus("^Resect$")
        screen.key("ctrl+q")
        window.process.wait(timeout=30)
        self.assertEqual(window.process.returncode, 0)

    def test_a_pick_hits_what_is_under_the_pointer_at_any_scale(self):
        for scale in ("1", "1.5", "2"):
            size = f"{int(1200 / float(scale))}x{int(900 / float(scale))}"
            window = Window(self.screen, "--spacing", "12mm", "--size", size, scale=scale)
            try:
                window.wait("ready")
                time.sleep(0.5)
                self.screen.picture(f"scale_{scale}_start")
                self.screen.click(*window.places["Hook"])
                window.wait("held Hook handle-box")
                self.screen.picture(f"scale_{scale}")
            finally:
                window.quit()

    def test_a_broken_file_is_a_sentence_in_the_window(self):
        broken = FOLDER / "broken.stl"
        broken.write_text("solid nothing\nfacet normal 0 0\n")
        window = Window(self.screen, "--spacing", "12mm", "--organ", str(broken))
        self.addCleanup(window.quit)
        self.assertIn("broken.stl", window.wait("error "))
        self.assertIsNone(window.process.poll())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
