"""experiments_view.py PROGRAM: pages of `tetracone view` in headless Chromium, by what they say of themselves and by screenshots.

Status 0: all is as it should be; 1: something is not, in a line each; 77: no Chromium or no Python imaging library here.
"""

import base64
import io
import itertools
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy
    from PIL import Image
except ImportError:
    print("skipped: no python3-pil and python3-numpy")
    sys.exit(77)
chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
if not chromium:
    print("skipped: no chromium")
    sys.exit(77)

program = sys.argv[1]
source = pathlib.Path(__file__).resolve().parents[2]
models = source / "verify" / "test" / "models"
failures = []


def check(right, what):
    if not right:
        failures.append(what)
        print("wrong:", what, file=sys.stderr)


class Browser:
    """Chromium without a screen, drawing in software."""

    def __init__(self, folder):
        self.folder = folder
        self.count = itertools.count()

    def run(self, page, fragment, *words, size=(900, 600), budget=5000):
        flags = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
                 f"--user-data-dir={self.folder}/profile", f"--window-size={size[0]},{size[1]}", f"--virtual-time-budget={budget}"]
        done = subprocess.run([chromium, *flags, *words, f"file://{page}#{fragment}"], capture_output=True, timeout=120, check=True)
        return done.stdout.decode()

    def state(self, page, fragment=""):
        dom = self.run(page, fragment, "--dump-dom")
        state = json.loads(re.search(r'id="state">([^<]*)<', dom).group(1))
        written = re.search(r'data-fragment="([^"]*)"', dom)
        state["fragment"] = written.group(1).replace("&amp;", "&").lstrip("#") if written else None
        state["verdict"] = re.search(r'<p id="verdict"[^>]*>([^<]*)', dom).group(1)
        state["contacts"] = re.search(r'<p id="contacts"[^>]*>([^<]*)', dom).group(1)
        return state

    def work(self, page, steps):
        """The state, and the canvas as a picture, after each step: {name: script}, one after the other in the same page."""
        functions = ",".join(f"{json.dumps(name)}: () => {{ {script} }}" for name, script in steps.items())
        driver = """<script type="application/json" id="results"></script><script>
          (async () => {
            const wait = time => new Promise(done => setTimeout(done, time)), results = {};
            const drawn = async () => { do await wait(30); while (waiting); };
            await drawn();
            for (const [name, step] of Object.entries({%s})) {
              await step();
              await drawn();
              renderer.render(scene, camera.lens);
              results[name] = {...JSON.parse(element('state').textContent), picture: canvas.toDataURL()};
            }
            element('results').textContent = JSON.stringify(results);
          })();
        </script></body>""" % functions
        worked = self.folder / "worked.html"
        # In virtual time frames are rare: timers take their place.
        frames = "<head><script>window.requestAnimationFrame = draw => setTimeout(draw, 10);</script>"
        worked.write_text(page.read_text().replace("<head>", frames, 1).replace("</body>", driver))
        results = json.loads(re.search(r'id="results">([^<]*)<', self.run(worked, "", "--dump-dom", budget=100000)).group(1))
        for name, result in results.items():
            check(result["errors"] == [], f"{name}: {result['errors']}")
            png = base64.b64decode(result["picture"].split(",")[1])
            result["picture"] = numpy.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)
        return results

    def picture(self, page, fragment="", size=(900, 600)):
        file = f"{self.folder}/{next(self.count)}.png"
        self.run(page, fragment, f"--screenshot={file}", size=size)
        return numpy.asarray(Image.open(file).convert("RGB")).astype(int)


def view(out, *words):
    subprocess.run([program, "view", *map(str, words), "--out", str(out)], check=True)
    return out


def near(picture, colour):
    """How many pixels of the bodies' part of the picture have about this colour."""
    return int((abs(picture[90:-80, :-270] - numpy.array(colour)).max(axis=2) <= 2).sum())


def marks(picture):
    """Pixels of the colour of wrong answers where the time line is."""
    return int((abs(picture[-60:] - numpy.array((213, 94, 0))).max(axis=2) < 10).sum())


def differ(a, b):
    return int((abs(a - b).max(axis=2) > 12).sum())


def hue(picture, name):
    """Pixels of the bodies' part whose hue is that of a colour of the style sheet, however lit."""
    part = picture[90:-80, :-270] / 255
    red, green, blue = part[..., 0], part[..., 1], part[..., 2]
    vivid = part.max(axis=2) - part.min(axis=2) > 0.15
    rule = {"a": (blue > green) & (green > red), "b": (green > blue) & (blue > red), "orange": (red > green) & (green > blue)}[name]
    return int((vivid & rule).sum())


with tempfile.TemporaryDirectory(prefix="tetracone_view_") as name:
    folder = pathlib.Path(name)
    poses = folder / "poses.txt"
    # Overlapping, touching, apart by less than a float can say, apart.
    poses.write_text("".join(f"1 0 0 {x} 0 1 0 0.25 0 0 1 0.25\n" for x in ("0.5", "1", "1.0000000001", "1.75")))
    pair = view(folder / "pair.html", models / "cube.off", models / "cube.off", "--pose-b", poses, "--kernel", "float")
    case = view(folder / "case.html", source / "verify" / "corpus" / "double-false-negative-pose-vertex-edge.case.json")
    predicate = view(folder / "predicate.html", source / "verify" / "corpus" / "double-false-negative-segment-triangle.case.json")
    alone = view(folder / "alone.html", models / "frame.poly")
    # Its bounds, rounded outward, are far beyond single precision.
    denormal = view(folder / "denormal.html", source / "verify" / "corpus" / "double-paper-false-negative-regular-hull-vertex-vertex.case.json")
    browser = Browser(folder)

    # Every page loads without an error and draws something.
    for page in (case, predicate, alone, denormal):
        state = browser.state(page, "show=a,b,edges,features,left,covering,tetrahedra,spheres,hull")
        check(state["ready"] and state["errors"] == [], f"{page.name}: {state['errors']}")
        check(state["triangles"] + state["lines"] + state["points"] > 0, f"{page.name} draws nothing")
    state = browser.state(case)
    check("exact: collide" in state["verdict"] and "double tree: apart" in state["verdict"] and "wrong" in state["verdict"], f"verdict: {state['verdict']}")
    check("2 lost" in state["contacts"], f"contacts: {state['contacts']}")
    check("wrong" in browser.state(predicate)["verdict"], "the predicate's case is not said to be wrong")

    # What each control is for: by the address, then by hand.
    layers = ("edges", "features", "left", "covering", "tetrahedra", "spheres", "hull")
    address = {"plain": "pose=1&show=a,b", "a": "pose=1&show=a", "pose 2": "pose=2", "pose 3": "pose=3", "pose 0": "pose=0",
               "odd": "pose=999&level=-3&show=nonsense,a&opacity=x&camera=1,2,no&theme=blue&shrink="}
    address |= {layer: f"pose=1&show=a,b,{layer}&opacity=0.3" for layer in layers} | {"faint": "pose=1&show=a,b&opacity=0.3"}
    drag = "for (const [type, x] of [['pointerdown', 300], ['pointermove', 350], ['pointerup', 350]]) canvas.dispatchEvent(new PointerEvent(type, {clientX: x, clientY: 300, pointerId: 1, buttons: 1}));"
    steps = {name: f"location.hash = '{text}'" for name, text in address.items()} | {
        "start": "location.hash = 'pose=0'", "next wrong": "element('next-wrong').click()", "before": "location.hash = 'pose=0&again'; return wait(20).then(() => element('before').click())",
        "slider": "element('pose').value = 1; element('pose').dispatchEvent(new Event('input'))",
        "box on": "document.querySelector('[data-show=hull]').click()", "box off": "document.querySelector('[data-show=hull]').click()",
        "fit": "element('fit').click()", "drag": "canvas.setPointerCapture = () => {};" + drag, "wheel": "canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -100}))",
        "to contact": "element('to-contact').click()", "theme": "element('theme').click()",
        "play": "element('play').click(); return wait(500)", "pause": "element('play').click(); return wait(500)"}
    done = browser.work(pair, steps)
    drawn = {name: result["triangles"] + result["lines"] for name, result in done.items()}
    check(done["plain"]["wrong"] == [2], f"wrong poses: {done['plain']['wrong']}")
    check(done["a"]["triangles"] * 2 == done["plain"]["triangles"], "B is not hidden")
    for layer in layers:
        check(drawn[layer] > drawn["plain"], f"{layer} adds nothing")
        check(differ(done[layer]["picture"], done["faint"]["picture"]) > 300, f"{layer} does not change the picture")
    check([done[f"pose {k}"]["exact"] for k in (0, 2, 3)] == [1, 0, 0], "exact answers by pose")
    check([done[f"pose {k}"]["answer"] for k in (0, 2, 3)] == [1, 1, 0], "answers by pose")
    odd = done["odd"]
    check(odd["ready"] and odd["pose"] == 3 and odd["level"] == 1 and odd["show"] == ["a"], f"an odd fragment: pose {odd['pose']}, level {odd['level']}, show {odd['show']}")
    check(done["next wrong"]["pose"] == 2, "'Next wrong' goes to the wrong pose")
    check(done["before"]["pose"] == 3, "the pose before the first is the last")
    check(done["slider"]["pose"] == 1, "the slider")
    check("hull" in done["box on"]["show"] and "hull" not in done["box off"]["show"], "the hull's box")
    camera = {name: [float(x) for x in result["camera"].split(",")] for name, result in done.items()}
    check(abs(camera["drag"][0] - camera["fit"][0] + 20) < 1e-6 and camera["drag"][1:] == camera["fit"][1:], f"a drag turns {camera['fit']} to {camera['drag']}")
    check(camera["wheel"][2] < camera["drag"][2] and camera["wheel"][3:] == camera["drag"][3:], "the wheel brings nearer")
    check(camera["to contact"][2] < camera["fit"][2], "'Go to contact' goes nearer")
    check(done["theme"]["picture"][5, 5].tolist() != done["to contact"]["picture"][5, 5].tolist(), "light or dark")
    check(done["play"]["pose"] != done["theme"]["pose"] and done["pause"]["pose"] == done["play"]["pose"], "play and pause")
    done = browser.work(alone, {str(level): f"location.hash = 'show=a,tetrahedra&level={level}'" for level in (1, 2, 3)})
    drawn = [done[str(level)]["triangles"] for level in (1, 2, 3)]
    check(drawn[0] < drawn[1] < drawn[2], f"levels 1, 2 and 3 draw {drawn} triangles")

    # What a page writes as its address gives the same page again.
    given = browser.state(pair, "pose=1&show=a,b,hull&camera=30,40,6,0.1,0.2,0.3&opacity=0.4")
    check(given["camera"] == "30,40,6,0.1,0.2,0.3", f"camera: {given['camera']}")
    again = browser.state(pair, given["fragment"])
    check(again == given, f"fragment {given['fragment']} gives {again}, expected {given}")

    # Screenshots: what must be there.
    bodies = browser.picture(pair, "pose=3&show=a,b&opacity=1")
    check(hue(bodies, "a") > 5000 and hue(bodies, "b") > 5000 and hue(bodies, "orange") == 0, "two bodies, blue and green")
    check(near(bodies, (255, 255, 255)) > 50000, "a light background")
    check(differ(bodies, browser.picture(pair, "pose=3&show=a,b&opacity=1")) == 0, "the same address gives the same picture")
    one = browser.picture(pair, "pose=3&show=a&opacity=1")
    check(hue(one, "a") > 5000 and hue(one, "b") == 0, "A alone")
    contact = browser.picture(pair, "pose=0&show=a,b,features&opacity=1")
    check(hue(contact, "orange") > 500, "colliding edges are orange")
    check(marks(contact) > 50, "the wrong pose is marked on the time line")
    clean = view(folder / "clean.html", models / "cube.off", models / "cube.off", "--pose-b", poses, "--kernel", "adaptive")
    check(marks(browser.picture(clean, "pose=0")) == 0, "no mark where nothing is wrong")
    dark = browser.picture(pair, "pose=3&show=a,b&opacity=1&theme=dark")
    check(near(dark, (21, 24, 27)) > 50000 and hue(dark, "a") > 5000, "a dark background")
    phone = browser.picture(pair, "pose=3&show=a,b", size=(500, 800))  # Chromium's windows are no narrower
    check(phone.shape[:2] == (800, 500) and differ(phone, numpy.full_like(phone, 255)) > 3000, "a phone's picture")

sys.exit(1 if failures else 0)
