"""experiments_view.py PROGRAM: pages of `tetracone view` in headless Chromium, by what they say of themselves and by screenshots.

Status 0: all is as it should be; 1: something is not, in a line each; 77: no Chromium or no Python imaging library here.
"""

import base64
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy
    from PIL import Image
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.wait import WebDriverWait
except ImportError:
    print("skipped: no python3-pil, python3-numpy and python3-selenium")
    sys.exit(77)
chromium, chromedriver = shutil.which("chromium"), shutil.which("chromedriver")
if not chromium or not chromedriver:
    print("skipped: no chromium and chromedriver")
    sys.exit(77)

program = sys.argv[1]
source = pathlib.Path(__file__).resolve().parents[4]
models = source / "verify" / "test" / "models"
failures = []


def check(right, what):
    if not right:
        failures.append(what)
        print("wrong:", what, file=sys.stderr)


class Browser:
    """Chromium without a screen, drawing in software. A page is asked when it says that it is ready, however long that takes."""

    def __enter__(self):
        options = webdriver.ChromeOptions()
        options.binary_location = chromium
        for flag in ("headless", "no-sandbox", "use-angle=swiftshader", "enable-unsafe-swiftshader", "hide-scrollbars", "no-first-run",
                     "disable-background-networking", "disable-component-update", "disable-sync"):
            options.add_argument(f"--{flag}")
        self.driver = webdriver.Chrome(service=Service(chromedriver), options=options)
        self.driver.set_script_timeout(100)
        return self

    def __exit__(self, *_):
        self.driver.quit()

    def open(self, page, fragment, size=(900, 600)):
        self.driver.get("about:blank")  # a new fragment alone would not load the page again
        metrics = {"width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": False}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        self.driver.get(f"file://{page}#{fragment}")
        WebDriverWait(self.driver, 100).until(lambda driver: driver.execute_script("return document.getElementById('state').textContent"))

    def state(self, page, fragment=""):
        self.open(page, fragment)
        return self.driver.execute_script("""
          writeFragment();
          return {...JSON.parse(element('state').textContent), fragment: location.hash.slice(1),
                  verdict: element('verdict').textContent, relation: element('relation').textContent, contacts: element('contacts').textContent};""")

    def work(self, page, steps):
        """The state, and the canvas as a picture, after each step: {name: script}, one after the other in the same page."""
        self.open(page, "")
        results = {name: self.driver.execute_async_script("""
          const done = arguments[0], wait = time => new Promise(after => setTimeout(after, time));
          clearTimeout(writing);  // the page's own address must not come between a step's and its event
          (async () => { %s })().then(async () => {
            do await wait(10); while (waiting);
            renderer.render(scene, camera.lens);
            done({...JSON.parse(element('state').textContent), picture: canvas.toDataURL()});
          });""" % script) for name, script in steps.items()}
        for name, result in results.items():
            check(result["errors"] == [], f"{name}: {result['errors']}")
            png = base64.b64decode(result["picture"].split(",")[1])
            result["picture"] = numpy.asarray(Image.open(io.BytesIO(png)).convert("RGB")).astype(int)
        return results

    def play(self, page, pictures):
        """What the page says of itself when it has played until that many pictures are drawn, or for 80 seconds."""
        self.open(page, "frame=0")
        return self.driver.execute_async_script("""
          const done = arguments[0], end = Date.now() + 80000;
          element('play').click();
          const timer = setInterval(() => {
            const shown = JSON.parse(element('state').textContent);
            if (shown.drawn >= %d || Date.now() > end) { clearInterval(timer); done(shown); }
          }, 50);""" % pictures)

    def picture(self, page, fragment="", size=(900, 600)):
        self.open(page, fragment, size)
        return numpy.asarray(Image.open(io.BytesIO(self.driver.get_screenshot_as_png())).convert("RGB")).astype(int)


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


with tempfile.TemporaryDirectory(prefix="tetracone_view_") as name, Browser() as browser:
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

    # 200 cubes on a line, every second frame each of them against the next.
    cubes = folder / "cubes.scene.json"
    row = lambda step: [[1, 0, 0, step * k, 0, 1, 0, 0, 0, 0, 1, k % 14] for k in range(200)]
    cubes.write_text(json.dumps({"models": {"cube": str(models / "cube.off")}, "bodies": [{"model": "cube"}] * 200,
                                 "frames": [row(1.5 if k % 2 else 0.05) for k in range(60)]}))
    scene = view(folder / "scene.html", cubes)

    # Models whose faces are triangles, as those of every STL: two that collide and one apart.
    (folder / "corner.stl").write_text("solid corner\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x} {y} {z}\n" for x, y, z in face) + "endloop\nendfacet\n"
        for face in (((0, 0, 0), (0, 1, 0), (1, 0, 0)), ((0, 0, 0), (1, 0, 0), (0, 0, 1)), ((0, 0, 0), (0, 0, 1), (0, 1, 0)),
                     ((1, 0, 0), (0, 1, 0), (0, 0, 1)))) + "endsolid corner\n")
    (folder / "corners.scene.json").write_text(json.dumps({"models": {"corner": "corner.stl"}, "bodies": [{"model": "corner"}] * 3,
                                                           "frames": [[[1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0] for x in (0, 0.5, 2)]]}))
    corners = view(folder / "corners.html", folder / "corners.scene.json")

    # Every page loads without an error and draws something.
    for page in (case, predicate, alone, denormal):
        state = browser.state(page, "show=a,b,edges,features,contacts,left,covering,tetrahedra,spheres,hull")
        check(state["ready"] and state["errors"] == [], f"{page.name}: {state['errors']}")
        check(state["triangles"] + state["lines"] + state["points"] > 0, f"{page.name} draws nothing")
    state = browser.state(case)
    check("exact: collide" in state["verdict"] and "double tree: apart" in state["verdict"] and "wrong" in state["verdict"], f"verdict: {state['verdict']}")
    check("2 lost" in state["contacts"], f"contacts: {state['contacts']}")
    check("wrong" in browser.state(predicate)["verdict"], "the predicate's case is not said to be wrong")

    # Bodies apart show how far, and a ray what it meets: along an edge, through two faces, past everything, from within.
    apart = browser.state(pair, "pose=3")
    check(apart["contacts"].startswith("Distance 0.75, ") and "nearest" in apart["show"], f"apart: {apart['contacts']}")
    check(browser.state(pair, "pose=0")["contacts"].find("Distance") < 0, "a distance of bodies that collide")
    rays = folder / "rays.txt"
    rays.write_text("-1 0 0 2 0 0\n-1 0.5 0.25 1 0 0\n-1 2 2 1 0 0\n0.5 0.5 0.5 0 0 3\n")
    cast = view(folder / "rays.html", models / "cube.off", "--rays", rays)
    check(browser.state(cast)["contacts"] == "4 rays, 3 of them meeting 7 faces.", f"rays: {browser.state(cast)['contacts']}")
    drawn = browser.work(cast, {name: f"location.hash = 'show={name}&opacity=0.3'" for name in ("a", "a,rays")})
    check(drawn["a,rays"]["triangles"] > drawn["a"]["triangles"], "rays add nothing")
    check(differ(drawn["a,rays"]["picture"], drawn["a"]["picture"]) > 1000, "rays do not change the picture")
    check(hue(browser.picture(cast, "show=rays"), "orange") > 100, "where rays meet faces is orange")
    check(near(browser.picture(cast, "show=rays"), (0, 114, 178)) > 500, "rays are blue")
    check(near(browser.picture(pair, "pose=3&show=nearest"), (26, 27, 28)) > 100, "the way between the nearest points is drawn")
    for words in (["--rays", folder / "none.txt"], [models / "cube.off", "--rays", rays]):
        refused = subprocess.run([program, "view", models / "cube.off", *words, "--out", folder / "no.html"], capture_output=True, text=True)
        check(refused.returncode == 2 and refused.stderr.count("\n") == 1 and not (folder / "no.html").exists(), f"{words}: {refused}")

    # Solids: the relation in words, the overlap and the way out drawn, and A moved out along it, by the address and by hand.
    out = view(folder / "out.html", models / "cube.off", models / "cube.off", "--pose-b", poses, "--depth")
    overlap = browser.state(out, "pose=0")
    check(overlap["relation"] == "Relation: overlap; the surfaces share lines. Volume of the overlap: 0.28125. Depth: 0.5, the least.", f"relation: {overlap['relation']}")
    check({"overlap", "way", "self"} <= set(overlap["show"]), f"shown at first: {overlap['show']}")
    check(browser.state(out, "pose=1")["relation"] == "Relation: meet; the surfaces share areas.", f"relation: {browser.state(out, 'pose=1')['relation']}")
    check(browser.state(out, "pose=3")["relation"] == "Relation: disjoint; the surfaces share nothing.", "the relation of bodies apart")
    done = browser.work(out, {name: f"location.hash = 'pose=0&opacity=0.3&{name}'" for name in ("show=a,b", "show=a,b,overlap", "show=a,b,way", "show=a,b&out=1", "show=a,b&out=0")} |
                        {"by hand": "element('out').value = 0.5; element('out').dispatchEvent(new Event('input'))"})
    for layer in ("overlap", "way"):
        check(done[f"show=a,b,{layer}"]["triangles"] > done["show=a,b"]["triangles"], f"{layer} adds nothing")
        check(differ(done[f"show=a,b,{layer}"]["picture"], done["show=a,b"]["picture"]) > 300, f"{layer} does not change the picture")
    check(differ(done["show=a,b&out=1"]["picture"], done["show=a,b"]["picture"]) > 1000, "A does not move out")
    check(differ(done["show=a,b&out=0"]["picture"], done["show=a,b"]["picture"]) == 0, "A does not move back")
    check((done["by hand"]["out"], done["show=a,b&out=1"]["out"]) == (0.5, 1), "the control that moves A out")
    check(hue(browser.picture(out, "pose=0&show=overlap"), "orange") > 500, "the overlap is yellow")
    arrow = near(browser.picture(out, "pose=0&show=way"), (26, 27, 28))
    check(100 < arrow < 10000, f"the way out has {arrow} pixels")
    check(hue(browser.picture(out, "pose=1&show=overlap"), "orange") == 0, "an overlap of bodies that touch")
    places = []
    for share in (0, 0.25, 1):
        browser.open(out, f"pose=0&out={share}")
        places.append(numpy.array(browser.driver.execute_script("return [...bodies[0].group.matrix.elements].slice(12, 15).map(x => x * world.extent)")))
    for share, place in zip((0.25, 1), places[1:]):
        check(numpy.allclose(place - places[0], [-0.5 * share, 0, 0]), f"A stands at {place - places[0]} after {share} of the way")
    along = view(folder / "along.html", models / "cube.off", models / "cube.off", "--pose-b", poses, "--along", "0", "0", "-2")
    check(browser.state(along)["relation"].endswith("First exit of A at 0.375, last at 0.375 lengths of the direction."), f"relation: {browser.state(along)['relation']}")
    check(browser.driver.execute_script("return getComputedStyle(element('out').parentNode).display") != "none", "no control that moves A out")
    browser.open(pair, "")
    check(browser.driver.execute_script("return getComputedStyle(element('out').parentNode).display") == "none", "a control that moves nothing")
    (folder / "crossing.off").write_text("OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -1\n1 1 1\n9 9 0\n3 0 1 2\n3 3 4 5\n")
    crossing = view(folder / "crossing.html", folder / "crossing.off")
    check(browser.state(crossing)["relation"] == "A intersects itself in 1 pair of faces.", f"relation: {browser.state(crossing)['relation']}")
    done = browser.work(crossing, {name: f"location.hash = 'show={name}&opacity=0.3'" for name in ("a", "a,self")})
    check(done["a,self"]["triangles"] > done["a"]["triangles"], "self-intersections add nothing")
    check(differ(done["a,self"]["picture"], done["a"]["picture"]) > 100, "self-intersections do not change the picture")

    # Moved out, A is in the picture, and the page says what belongs to where A was. Else nothing changes.
    moved = browser.state(out, "pose=0&out=1")
    said = "A is moved 100 % of the way out. Verdict, overlap and pairs are those of 0 %."
    check(moved["relation"].endswith(said), f"relation: {moved['relation']}")
    cameras = [browser.state(along, f"pose=0&out={share}")["camera"] for share in (0, 1)]
    check(cameras[0] != cameras[1], "A moves out of the picture")
    touching = [browser.state(out, f"pose=1&out={share}") for share in (0, 1)]
    check(all(touching[0][what] == touching[1][what] for what in ("triangles", "relation")), f"touching: {touching}")

    # Far from the origin the picture is that near it; so are the marks of a pose when another pose is far away.
    half = folder / "half.txt"
    half.write_text("1 0 0 1/2 0 1 0 1/4 0 0 1 1/3\n")
    def a_cube(name, scale, x):
        corners = "".join(f"{x + scale * (v & 1)!r} {scale * (v >> 1 & 1)!r} {scale * (v >> 2)!r}\n" for v in range(8))
        faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n"
        (folder / name).write_text("OFF\n8 6 0\n" + corners + faces)
        return folder / name
    def bodies_of(page, fragment):
        return browser.picture(page, fragment)[90:-80, :-270]
    here, there = a_cube("here.off", 1., 0.), a_cube("there.off", 1., 1e8)
    near_pair = view(folder / "here.html", here, here, "--pose-b", half, "--depth")
    far_pair = view(folder / "there.html", there, there, "--pose-b", half, "--depth")
    layers = "show=a,b,overlap,way,contacts,tetrahedra,spheres&opacity=0.3"
    drawn = [bodies_of(page, layers) for page in (near_pair, far_pair)]
    check(differ(*drawn) < 500, f"far from the origin {differ(*drawn)} pixels differ")
    (folder / "wide.txt").write_text(half.read_text() + "1 0 0 1e7 0 1 0 1/4 0 0 1 1/3\n")
    wide = view(folder / "wide.html", here, here, "--pose-b", folder / "wide.txt", "--depth")
    drawn = [bodies_of(page, "pose=0&show=overlap,left") for page in (near_pair, wide)]
    check(differ(*drawn) < 500, f"beside a far pose {differ(*drawn)} pixels of marks differ")

    # Sizes beyond single precision, and an overlap beyond the doubles.
    for name, scale in (("tiny", 1e-50), ("huge", 1e200), ("largest", 1.5e308)):
        a_cube(f"{name}.off", scale, 0.)
        two = {"models": {"c": f"{name}.off"}, "bodies": [{"model": "c"}] * 2,
               "frames": [[[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]] * 2]}
        (folder / f"{name}.scene.json").write_text(json.dumps(two))
        picture = browser.picture(view(folder / f"{name}.html", folder / f"{name}.scene.json"))
        check(hue(picture, "orange") > 500, f"a scene of the size {scale} is blank")
    state = browser.state(view(folder / "overlap.html", folder / "huge.off", folder / "huge.off"))
    check("Volume of the overlap: beyond the doubles." in state["relation"], f"relation: {state['relation']}")

    # A body within another has no contact to go to; six digits are shown of numbers.
    (folder / "within.txt").write_text("1/3 0 0 1/3 0 1/3 0 1/3 0 0 1/3 1/3\n")
    browser.open(view(folder / "within.html", here, here, "--pose-b", folder / "within.txt"), "")
    check(browser.driver.execute_script("return element('to-contact').disabled"), "'Go to contact' without a contact")
    (folder / "third.txt").write_text("1 0 0 4/3 0 1 0 0 0 0 1 0\n")
    third = browser.state(view(folder / "third.html", here, here, "--pose-b", folder / "third.txt"))
    check(third["contacts"].startswith("Distance 0.333333, "), f"contacts: {third['contacts']}")

    # The panel does not cover what stands at the left.
    for width in (641, 730, 820):
        browser.open(out, "pose=0", size=(width, 600))
        header, panel = browser.driver.execute_script(
            "return [document.querySelector('header'), element('panel')].map(x => x.getBoundingClientRect().toJSON())")
        check(header["right"] <= panel["left"], f"{width} pixels wide, the panel covers the header: {header}, {panel}")

    # What each control is for: by the address, then by hand.
    layers = ("edges", "features", "contacts", "left", "covering", "tetrahedra", "spheres", "hull")
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
        "play": "const before = state.pose; element('play').click(); while (state.pose === before) await wait(10);",
        "pause": "element('play').click(); const at = state.pose; await wait(500); if (state.pose !== at) errors.push('it plays on'); changed()"}
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
    # A scene of many bodies: which are marked, and that it plays on. How smoothly it plays is not tested, since other tests use the processors too.
    apart, together = (browser.picture(scene, f"frame={k}") for k in (1, 0))
    check(hue(apart, "a") > 500 and hue(apart, "orange") == 0, "bodies that are apart are blue")
    check(hue(together, "orange") > 500 and hue(together, "a") == 0, "bodies that collide are orange")
    drawn = browser.picture(corners)
    check(hue(drawn, "a") > 500 and hue(drawn, "orange") > 500, "bodies of triangles are drawn")
    # A call takes no more than some 100,000 arguments.
    browser.open(corners, "")
    errors = browser.driver.execute_script("data.pairs = Array(300000).fill([]); drawLine(); return errors")
    check(errors == [], f"a line of 300,000 frames: {errors}")
    shown = browser.play(scene, 20)
    check(shown["errors"] == [] and shown["bodies"] == 200, f"the scene's page: {shown}")
    check(shown["drawn"] >= 20, f"{shown['drawn']} pictures while a scene of 200 bodies played")
    # A motion is played to its first contact and no further, with what meets there marked.
    (folder / "start.txt").write_text("1 0 0 0.25 0 1 0 0.25 0 0 1 3\n")
    (folder / "end.txt").write_text("1 0 0 0.25 0 1 0 0.25 0 0 1 -3\n")
    falls = view(folder / "falls.html", models / "cube.off", models / "tetrahedron.poly", "--pose-b0", folder / "start.txt", "--pose-b1", folder / "end.txt")
    done = browser.work(falls, {"start": "location.hash = 'pose=0'", "start, bare": "location.hash = 'pose=0&show=a,b,edges'",
                                "end": "location.hash = 'pose=59'; return wait(20).then(async () => { element('play').click(); await wait(300); })"})
    check(done["end"]["pose"] == done["end"]["poses"] - 1, f"the motion stands at pose {done['end']['pose']} of {done['end']['poses']}")
    check(differ(done["start"]["picture"], done["start, bare"]["picture"]) > 100, "what meets first is marked")
    end = browser.state(falls, "pose=999")
    check("first contact " in end["verdict"] and " of A, " in end["verdict"], f"verdict: {end['verdict']}")
    for words in (["--pose-a", poses], ["--pose-b1", poses]):
        refused = subprocess.run([program, "view", models / "cube.off", models / "cube.off", "--pose-b0", folder / "start.txt", *words, "--out", folder / "no.html"],
                                 capture_output=True, text=True)
        check(refused.returncode == 2 and refused.stderr.count("\n") == 1 and not (folder / "no.html").exists(), f"{words}: {refused}")
    phone = browser.picture(pair, "pose=3&show=a,b", size=(360, 640))
    check(phone.shape[:2] == (640, 360) and differ(phone, numpy.full_like(phone, 255)) > 3000, "a phone's picture")

sys.exit(1 if failures else 0)
