"""A virtual screen with mouse and keyboard, and the window on it."""
import os
import queue
import shutil
import struct
import subprocess
import threading
import time
import unittest
import zlib


class Screen:
    """A virtual screen of its own; pictures and settings go to `folder`."""

    def __init__(self, folder, width=1280, height=1024):
        self.folder, self.size = folder, f"{width}x{height}x24"
        for _ in range(5):
            number = self.start()
            if number:
                break
        else:
            raise AssertionError("Xvfb does not start")
        # The language of whoever runs the tests is not that of the window.
        self.environment = {**os.environ, "DISPLAY": ":" + number, "LC_ALL": "C.UTF-8", "LANGUAGE": "",
                            "QT_QPA_PLATFORM": "xcb", "XDG_CONFIG_HOME": str(folder / "config"),
                            "XDG_STATE_HOME": str(folder / "state"),
                            "XDG_RUNTIME_DIR": str(folder)}

    def start(self):
        """Number of the display; nothing when there is none."""
        read, write = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", self.size, "-nolisten", "tcp", "-noreset"],
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

    def do(self, *args, timeout=30):
        subprocess.run(["xdotool", *map(str, args)], env=self.environment, timeout=timeout, check=True)

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

    def windows(self, name, what="--name"):
        """Those of the windows that can be seen whose title or class has `name`, a regular expression, in it."""
        return subprocess.run(["xdotool", "search", "--onlyvisible", what, name], env=self.environment,
                              capture_output=True, text=True, timeout=30).stdout.split()

    def choose(self, x, y, *keys):
        """Opens the list at a place and chooses from it with keys. A list that is still open would swallow the next
        click, so this waits until it has gone."""
        before = len(self.windows(".", "--class"))  # a list has no title
        self.click(x, y)
        self.until(lambda: len(self.windows(".", "--class")) > before, "no list opened")
        self.key(*keys)
        self.until(lambda: len(self.windows(".", "--class")) <= before, "the list did not close")

    def until(self, holds, complaint):
        end = time.time() + 20
        while not holds():
            if time.time() > end:
                raise AssertionError(complaint)
            time.sleep(0.1)

    def focus(self, title):
        """Without a window manager nobody gives the focus to a dialog, or back when it closes."""
        for _ in range(50):
            windows = self.windows(title)
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
        self.do("type", "--delay", "20", str(text))
        time.sleep(0.3)

    def dump(self, *which):
        """Rows of RGB bytes, width, height, left, top of a window; None where it has gone meanwhile."""
        done = subprocess.run(["xwd", "-silent", *which], env=self.environment, capture_output=True, timeout=30)
        if done.returncode != 0:
            return None
        header = struct.unpack(">25I", done.stdout[:100])
        size, width, height, stride, colours = header[0], header[4], header[5], header[12], header[19]
        left, top = struct.unpack(">2i", done.stdout[88:96])
        pixels, step = done.stdout[size + 12 * colours:], header[11] // 8
        rows = []
        for y in range(height):
            row = pixels[y * stride:y * stride + step * width]  # blue, green, red, perhaps a spare byte
            rgb = bytearray(3 * width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::step], row[1::step], row[0::step]
            rows.append(rgb)
        return rows, width, height, left, top

    def picture(self, name):
        """Rows of RGB bytes; also kept as a PNG. A dump of the whole screen has holes where windows have a visual of
        their own, so each window is dumped too and laid over it, the smallest on top."""
        rows, width, height, _, _ = self.dump("-root")
        windows = [self.dump("-id", window) for window in self.windows(".")]
        for part, w, h, left, top in sorted((w for w in windows if w), key=lambda w: -w[1] * w[2]):
            for y in range(max(0, top), min(height, top + h)):
                first, last = max(0, left), min(width, left + w)
                if first < last:
                    rows[y][3 * first:3 * last] = part[y - top][3 * (first - left):3 * (last - left)]
        rows = [bytes(row) for row in rows]

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        (self.folder / f"{name}.png").write_bytes(
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

    def __init__(self, program, screen, *args, scale="1", environment=None):
        environment = {**screen.environment, "QT_SCALE_FACTOR": scale, **(environment or {})}
        self.complaints = screen.folder / "complaints.txt"
        with self.complaints.open("a") as complaints:
            self.process = subprocess.Popen([program, "window", "--reports", *args], env=environment,
                                            cwd=screen.folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                            stderr=complaints, text=True)
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
                complaints = self.complaints.read_text()[-600:]
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


class ScreenTest(unittest.TestCase):
    """Tests of `program` on a screen of their own; pictures and settings go to `folder`, which is made anew."""
    program = folder = None

    def opened(self, *args):
        """A window, ready and with the keys."""
        window = Window(self.program, self.screen, "--size", "1240x900", *args)
        self.addCleanup(window.quit)
        window.wait("ready")
        self.screen.focus("^Resect")
        return window

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(cls.folder, ignore_errors=True)
        cls.folder.mkdir(parents=True, mode=0o700)
        cls.screen = Screen(cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.screen.close()
