"""Somebody who tries everything: random clicks, drags, keys, wheel, menus and files.

Afterwards the program must still run, hold nothing after Escape and Space, take and put back an instrument as ever,
and keep no more memory than at half time, measured with the same organ.
"""
import random
import subprocess
import time
from pathlib import Path

from screen import Screen, Window

MOST_GROWTH = 48  # MB from half time to the end: pools of threads and drivers fill up slowly
KEYS = ("1", "2", "3", "4", "Escape", "space", "h", "l", "d", "s", "f", "b", "t", "g", "c", "Left", "Right", "Up", "Down", "Prior",
        "Next", "shift+Left", "shift+Up", "shift+Prior", "ctrl+1", "ctrl+2", "ctrl+3", "ctrl+4", "F1", "F11", "Tab",
        "ctrl+o", "ctrl+s", "ctrl+e", "ctrl+p", "ctrl+r", "5", "9", "x")
MENUS = {"alt+f": 7, "alt+v": 16, "alt+i": 3, "alt+h": 1}  # entries that may be chosen, below the first: not Quit
DIALOGS = {"Open", "Open organ", "Save surface", "Save scene", "Save picture", "Record film", "About Resect"}
SCENARIOS = [Path(__file__).resolve().parents[2] / "data/scenarios" / f"{name}.toml"
             for name in ("cut-120", "cut-950", "perforate-120", "press", "no-such")]


class Person:
    def __init__(self, program, folder, seed, organ):
        self.program, self.folder, self.organ = program, folder, organ
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        self.random = random.Random(seed)
        self.screen = Screen(folder)
        self.window, self.starts = None, 0
        (folder / "broken.stl").write_text("solid nothing\nfacet normal 0 0\n")

    def start(self):
        self.starts += 1
        self.window = Window(self.program, self.screen, *self.organ, "--size", "1240x900")
        self.window.wait("ready", 300)

    def place(self):
        if self.random.random() < 0.4 and self.window.places:  # where things are
            x, y = self.random.choice(list(self.window.places.values()))
            x, y = x + self.random.gauss(0, 25), y + self.random.gauss(0, 25)
            return min(max(int(x), 0), 1239), min(max(int(y), 0), 899)  # an instrument may lie out of the picture
        return self.random.randrange(1240), self.random.randrange(900)

    def act(self):
        kind, do = self.random.random(), self.screen.do
        if kind < 0.20:
            button = self.random.choice((1, 1, 1, 2, 3))
            do("mousemove", *self.place(), "click", *(["--repeat", 2] if self.random.random() < 0.2 else []), button)
        elif kind < 0.50:
            (x, y), (u, v), steps = self.place(), self.place(), self.random.randrange(2, 14)
            way = [word for i in range(1, steps + 1)
                   for word in ("mousemove", int(x + (u - x) * i / steps), int(y + (v - y) * i / steps), "sleep", 0.02)]
            held = ["keydown", "shift"] if self.random.random() < 0.25 else []
            button = self.random.choice((1, 1, 1, 2, 3))
            do("mousemove", x, y, *held, "mousedown", button, *way, "mouseup", button, *(["keyup", "shift"] if held else []))
        elif kind < 0.60:
            held = self.random.choice(([], ["ctrl"], ["shift"]))
            do("mousemove", *self.place(), *(["keydown", *held] if held else []), "click", "--repeat",
               self.random.randrange(1, 12), self.random.choice((4, 5)), *(["keyup", *held] if held else []))
        elif kind < 0.85:
            do("key", "--delay", 15, *self.random.choices(KEYS, k=self.random.randrange(1, 5)))
        elif kind < 0.90:
            menu, entries = self.random.choice(list(MENUS.items()))
            do("key", "--delay", 30, menu, *["Down"] * self.random.randrange(entries + 1),
               self.random.choice(("Return", "Right", "Escape")), "Escape", "Escape")
        elif kind < 0.95:
            name, folder = self.random.choice(SCENARIOS), self.folder
            self.window.tell(self.random.choice((
                f"open {name}", f"open {folder}/scene.iv", f"open {folder}/surface.stl", f"open {folder}/broken.stl",
                f"save-scene {folder}/scene.iv", f"save-surface {folder}/surface.stl", f"save-picture {folder}/picture.png",
                f"save-picture {folder}/none/picture.png", "picture-size 700 500", "nonsense")))
        else:
            self.answer_dialogs()

    def let_go(self):
        """No key or button stays down when an act was cut short."""
        self.screen.do("keyup", "shift", "keyup", "ctrl", "mouseup", 1, "mouseup", 2, "mouseup", 3)

    def windows(self):
        """Of this program, but the main one: number and name."""
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(self.window.process.pid)],
                               env=self.screen.environment, capture_output=True, text=True, timeout=30).stdout.split()
        named = [(number, subprocess.run(["xdotool", "getwindowname", number], env=self.screen.environment, timeout=30,
                                         capture_output=True, text=True).stdout.strip()) for number in found]
        return [(number, name) for number, name in named if not name.startswith("Resect")]

    def answer_dialogs(self, answer=None):
        """Each open dialog gets Return or Escape."""
        for number, _ in self.windows():
            key = answer or self.random.choice(("Return", "Escape", "Escape"))
            subprocess.run(["xdotool", "windowfocus", number, "key", key], env=self.screen.environment, timeout=30,
                           stderr=subprocess.DEVNULL)  # it may have gone meanwhile

    def held(self):
        said = [line for line in self.window.said if line.startswith("held ")]
        return said[-1] if said else "held nothing none"

    def everything_back(self):
        """What Escape and Space promise, from whatever state the window is in."""
        for attempt in range(4):
            self.let_go()
            time.sleep(1)
            for _ in range(6):
                if not any(name in DIALOGS for _, name in self.windows()):
                    break
                self.answer_dialogs("Escape")
                time.sleep(0.5)
            self.window.drain()
            self.screen.focus("^Resect")
            self.screen.key("Escape", "Escape", "space")
            try:
                self.window.wait("places", 30)
                time.sleep(0.5)
                self.window.drain()
                assert self.held().startswith("held nothing"), f"after Escape and Space: {self.held()}"
                at = dict(self.window.places)
                for key, held in (("1", "held Scalpel "), ("t", "held Scalpel trackball"),
                                  ("b", "held Scalpel handle-box"), ("Escape", "held nothing")):
                    self.screen.key(key)
                    self.window.wait(held, 30)
                self.screen.key("space")
                self.window.wait("places", 30)
                assert self.window.places == at, f"not everything is back: {self.window.places}, not {at}"
                return
            except AssertionError:
                # An organ, or a dialog about one, that was still being read may have come in between.
                if attempt == 3 or self.window.process.poll() is not None:
                    self.screen.picture("stuck")
                    raise

    def memory(self):
        """MB in use with the organ of the beginning."""
        self.window.drain()
        self.window.tell(f"open {SCENARIOS[0]}")
        self.window.wait("organ liver", 120)
        time.sleep(2)
        with open(f"/proc/{self.window.process.pid}/status", encoding="ascii") as status:
            return next(int(line.split()[1]) / 1024 for line in status if line.startswith("VmRSS"))


def play(program, folder, seconds, seed, organ=("--spacing", "8mm")):
    """0 when the program came through it."""
    person, half = Person(program, folder, seed, organ), None
    begun, actions, checked = time.time(), 0, time.time()
    try:
        person.start()
        # On a machine that is busy with other things a few acts may take all of the time.
        while time.time() - begun < seconds or actions < 10:
            try:
                person.act()
                actions += 1
            except (BrokenPipeError, subprocess.SubprocessError) as problem:
                print(f"act {actions}: {problem}")
                person.let_go()
                time.sleep(1)
            person.window.drain()
            status = person.window.process.poll()
            if status is not None:
                # Closed from its menu, which is allowed; anything else is not.
                assert status == 0, f"the window ended with status {status}; see {person.window.complaints}"
                person.start()
                half = None
            if time.time() - checked > 20:
                person.everything_back()
                checked = time.time()
            if half is None and time.time() - begun > seconds / 2:
                person.everything_back()
                half = person.memory()
        person.everything_back()
        half = half or person.memory()  # it was started again late
        end = person.memory()
        print(f"{actions} random acts in {time.time() - begun:.0f} s (seed {seed}), started {person.starts} times; "
              f"memory {half:.0f} MB at half time, {end:.0f} MB at the end")
        assert end - half <= MOST_GROWTH, f"it keeps {end - half:.0f} MB more than at half time"
        person.screen.focus("^Resect")
        person.screen.key("ctrl+q")
        person.window.process.wait(timeout=120)
        assert person.window.process.returncode == 0, f"it ended with {person.window.process.returncode}"
        return 0
    except AssertionError:
        print(f"seed {seed}, {actions} acts, {time.time() - begun:.0f} s; the last it said: {person.window.said[-20:]}")
        raise
    finally:
        if person.window and person.window.process.poll() is None:
            person.window.quit()
        person.screen.close()
