"""Rates and latencies of the window in use. Draws with the mouse and reads what the program reports."""
import re
import statistics
import time

from screen import Screen, Window

RATE = re.compile(r"rate ([\d.]+) drawing ([\d.]+) ms latency (\d+) ms most (\d+) ms pictures (\d+) late (\d+) of (\d+) "
                  r"removal (\d+)")
UPLOADED = re.compile(r"uploaded (\d+) of (\d+) vertices")


def zigzag(centre, half_width, down, strokes, steps):
    """Points of a pointer that goes to and fro, and `down` pixels down by and by."""
    points = []
    for stroke in range(strokes):
        for step in range(steps):
            along = (2 * step / steps - 1) * (1 if stroke % 2 == 0 else -1)
            points.append((centre[0] + half_width * along,
                           centre[1] + down * (stroke + step / steps) / strokes))
    return points


def drawn(screen, window, points, button=1):
    """The program's reports while the pointer goes through the points, 60 of them a second."""
    screen.move(*points[0])
    screen.do("mousedown", button)
    window.drain()
    before = len(window.said)
    moves = [word for x, y in points for word in ("mousemove", int(x), int(y), "sleep", 0.0167)]
    screen.do(*moves, timeout=120)
    screen.do("mouseup", button)
    window.drain()
    return window.said[before:]


def forward(screen, window, most):
    """Away from the eye, until something is removed."""
    for _ in range(most):
        screen.do("click", 4)
        time.sleep(0.1)
        window.drain()
        if any(line.startswith("removed ") for line in window.said):
            break


def strongest(said):
    """The largest force that the instrument in hand has felt, N."""
    return max((float(line.split()[1]) for line in said if line.startswith("force ")), default=0)


def row(what, said):
    rates = [tuple(map(float, RATE.match(line).groups())) for line in said if line.startswith("rate ")]
    uploads = [tuple(map(int, UPLOADED.match(line).groups())) for line in said if line.startswith("uploaded ")]
    rates, uploads = rates[1:], uploads[1:]  # the first second began before
    if not rates:
        return f"| {what} | no picture | | | | | | | | |"
    removed = [line for line in said if line.startswith("removed ")]
    rate, drawing, latency, most, pictures, late, inputs, removal = zip(*rates)
    sent = sum(n for n, _ in uploads) / max(1.0, sum(rate))
    return (f"| {what} | {statistics.median(rate):.1f} ({min(rate):.1f}) | {statistics.median(drawing):.0f} ms | {statistics.median(latency):.0f} ms | "
            f"{max(most):.0f} ms | {max(pictures):.0f} | {sum(late):.0f} of {sum(inputs):.0f} | {max(removal):.0f} | {sent:.0f} of {uploads[-1][1]} | "
            f"{removed[-1].split()[1] if removed else 0} | {strongest(said):.1f} N |")


HEAD = ("| {} | pictures/s: median (least) | drawing one | input to picture: median | longest | in pictures, at most | "
        "later than two pictures | "
        "removed particles gone in picture | vertices sent per picture | particles removed | largest force |\n" + "|---" * 11 + "|")


def measure(program, folder, seconds=8):
    still(program, folder, seconds)
    elastic(program, folder, seconds)


def elastic(program, folder, seconds):
    """Baton, hook and scalpel on tissue that gives way, at 8 mm: the motions of three scenarios."""
    screen = Screen(folder, 1700, 1000)
    window = None
    try:
        print(HEAD.format("elastic liver at 8 mm, picture 1280 x 770"), flush=True)
        for what, scenario in (("the baton presses", "press"), ("the hook lifts", "lift"), ("the scalpel cuts", "incise")):
            window = Window(program, screen, scenario, "--size", "1600x860")
            window.wait("ready", 180)
            window.tell("picture-size 1280 770")
            window.wait("places")
            time.sleep(3)
            window.drain()
            before = len(window.said)
            window.tell(f"play {seconds}")
            time.sleep(0.5 * seconds)
            screen.picture("elastic_" + scenario)
            window.wait("played", 10 * seconds)
            print(row(what, window.said[before:]), flush=True)
            window.quit()
    finally:
        if window and window.process.poll() is None:
            window.quit()
        screen.close()


def still(program, folder, seconds):
    screen = Screen(folder, 1700, 1000)
    window = None
    try:
        window = Window(program, screen, "--thesis", "--spacing", "5mm", "--size", "1600x860")
        window.wait("ready", 180)
        window.tell("picture-size 1280 770")
        window.wait("places")
        organ = window.places["organ"]
        print(HEAD.format("liver at 5 mm, picture 1280 x 770"), flush=True)
        screen.click(organ[0], organ[1] + 200)
        screen.key("1")
        window.wait("held Scalpel direct")
        strokes = max(1, seconds // 2)
        print(row("the scalpel is moved over it", drawn(screen, window, zigzag(organ, 110, 0, strokes, 120))), flush=True)
        drawn(screen, window, zigzag(organ, 1, 60, 1, 60))
        forward(screen, window, 24)
        print(row("it is drawn through the dome", drawn(screen, window, zigzag(organ, 110, 70, strokes, 120))), flush=True)
        screen.picture("cut")
        print(row("the camera goes round", drawn(screen, window, zigzag(organ, 200, 0, strokes, 120), button=3)), flush=True)
        window.quit()
    finally:
        if window and window.process.poll() is None:
            window.quit()
        screen.close()
