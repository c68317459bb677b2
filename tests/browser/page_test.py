#!/usr/bin/python3
"""Drives the pages of cosurge report, check --picture and watch in a headless browser.

Usage: page_test.py FOLDER_OF_THE_PROGRAMS SOURCE_FOLDER
"""
import json
import re
import subprocess
import sys
import tempfile
import unittest
import urllib.error
import urllib.request
from pathlib import Path

from browser import Browser, require_browser
from runs import Runs

RUNS = None
BROWSER = None


class Page(unittest.TestCase):
    def opened(self, page):
        seconds = BROWSER.open(page)
        self.assertEqual(BROWSER.trouble(), "")
        self.addCleanup(lambda: self.assertEqual(BROWSER.errors(), []))
        return seconds

    def expect_drawn(self, colors=20):
        now = BROWSER.colors()
        self.assertGreater(now["drawn"], 500)
        self.assertGreater(now["colors"], colors)
        return now

    def expect_plays(self):
        BROWSER.scrub(0)
        BROWSER.find(".play").click()
        BROWSER.wait("return cosurge.player.time > 0.1 * cosurge.player.end", 20, "the scene to play")
        BROWSER.find(".play").click()
        stopped = BROWSER.do("return [cosurge.player.time, cosurge.scene.time]")
        self.assertEqual(stopped[0], stopped[1])
        self.assertEqual(BROWSER.do("return cosurge.player.time"), stopped[0])

    def expect_scrubs(self):
        BROWSER.scrub(0.02)
        early = self.expect_drawn()
        BROWSER.scrub(0.9)
        late = self.expect_drawn()
        self.assertNotEqual(early["sum"], late["sum"], "the scene does not move")
        time, end = BROWSER.do("return [cosurge.scene.time, cosurge.player.end]")
        self.assertAlmostEqual(time, 0.9 * end, delta=1e-3 * end)

    def expect_zooms(self):
        from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
        canvas = BROWSER.find("canvas.over")
        measure = "return cosurge.scene.dimension === 2 ? cosurge.scene.camera.scale : 1 / cosurge.scene.camera.distance"
        view = "return JSON.stringify(cosurge.scene.camera.matrix())"
        BROWSER.do("window.scrollTo(0, 0)")
        before = BROWSER.do(measure)
        BROWSER.mouse().scroll_from_origin(ScrollOrigin.from_element(canvas), 0, -400).perform()
        self.assertGreater(BROWSER.do(measure), 1.3 * before)
        seen = BROWSER.do(view)
        BROWSER.mouse().move_to_element(canvas).click_and_hold().move_by_offset(60, 30).release().perform()
        self.assertNotEqual(BROWSER.do(view), seen, "dragging does nothing")
        BROWSER.mouse().move_to_element(canvas).double_click().perform()
        self.assertAlmostEqual(BROWSER.do(measure), before, delta=1e-9 * before)

    def expect_cursor_follows(self):
        """The line in the charts is at the time of the scene, and the mouse over a chart sets it."""
        BROWSER.do("document.querySelector('#charts').scrollIntoView()")
        BROWSER.wait("return cosurge.charts[0].plot", 10, "the first chart")
        BROWSER.scrub(0.5)
        line, right = BROWSER.do("""const {line, plot} = cosurge.charts[0];
            return [new DOMMatrix(getComputedStyle(line).transform).e, plot.valToPos(cosurge.player.time, 'x')];""")
        self.assertAlmostEqual(line, right, delta=1)
        BROWSER.wait(r"return /\d/.test(cosurge.charts[0].plotRoot.querySelector('.u-legend').textContent.replace(/^t:/, ''))",
                     5, "values in the legend")
        over = BROWSER.find(".chart .u-over")
        BROWSER.mouse().move_to_element_with_offset(over, 40, 0).perform()
        expected = BROWSER.do("return cosurge.charts[0].plot.posToVal(cosurge.charts[0].plot.over.clientWidth / 2 + 40, 'x')")
        end = BROWSER.do("return cosurge.player.end")
        self.assertAlmostEqual(BROWSER.do("return cosurge.scene.time"), min(expected, end), delta=0.01 * end)
        BROWSER.do("window.scrollTo(0, 0)")

    def expect_all(self, name):
        self.expect_plays()
        self.expect_scrubs()
        self.expect_zooms()
        self.expect_cursor_follows()
        BROWSER.scrub(0.8)
        BROWSER.screenshot(name)

    def test_a_coupled_run(self):
        folder = RUNS.coupled()
        self.opened(RUNS.report(folder, name="coupled"))
        self.expect_all("coupled")
        self.assertIn("no objection", BROWSER.find("#verdicts").text)
        summary = json.loads((folder / "summary.json").read_text())
        peak_value = summary["probes"]["tip_x"]["peak"]["value"]
        row = BROWSER.do("return [...document.querySelectorAll('#tables tr')].find((r) => r.textContent.startsWith('solid: tip x')).textContent")
        self.assertIn(f"{float(f'{1000 * peak_value:.4g}'):g}", row)
        for tab, words in (("Impulses", "force x"), ("Energy and work", "sum of energies"), ("Cost", "ppe solve"),
                           ("Case", "young_modulus")):
            BROWSER.do("[...document.querySelectorAll('.tabs button')].find((b) => b.textContent === arguments[0]).click()", tab)
            self.assertIn(words, BROWSER.find(".tabbody").text, tab)
        self.assertIn("cosurge run", BROWSER.find(".tabbody").text)

    def test_values_under_the_mouse(self):
        self.opened(RUNS.report(RUNS.coupled(), name="values"))
        place = BROWSER.do("const [x, y] = cosurge.scene.camera.project([0.07, 0.03]); const c = cosurge.scene.camera;"
                           "return [Math.round(x - c.width / 2), Math.round(y - c.height / 2)]")
        BROWSER.mouse().move_to_element_with_offset(BROWSER.find("canvas.over"), *place).perform()
        tip = BROWSER.find(".tip").text
        self.assertIn("water", tip)
        self.assertRegex(tip, r"pressure: about \d")

    def test_logarithms_and_spectra(self):
        self.opened(RUNS.report(RUNS.solid(), name="spectra"))
        BROWSER.wait("return cosurge.charts[0].plot", 10, "the first chart")
        BROWSER.find(".chart [data-do=frequency]").click()
        peak = BROWSER.do("const [f, a] = cosurge.charts[0].plot.data; return f[a.indexOf(Math.max(...a))]")
        self.assertAlmostEqual(peak, 5.97, delta=1)  # cases/cantilever; the run has 1.2 s: lines every 0.83 Hz
        BROWSER.find(".chart [data-do=frequency]").click()
        BROWSER.find(".chart [data-do=log]").click()
        self.assertEqual(BROWSER.do("return cosurge.charts[0].plot.scales.y.distr"), 3)
        self.assertTrue(BROWSER.do("return cosurge.charts[0].plot.data[1].every((v) => v === null || v > 0)"))

    def test_water_alone_whose_wall_moves(self):
        self.opened(RUNS.report(RUNS.water(), name="water"))
        self.expect_all("water")

    def test_a_structure_alone(self):
        self.opened(RUNS.report(RUNS.solid(), name="solid"))
        self.expect_all("solid")

    def test_three_dimensions(self):
        self.opened(RUNS.report(RUNS.space(), name="space"))
        self.expect_all("space")

    def test_an_interrupted_and_a_killed_run(self):
        self.opened(RUNS.report(RUNS.interrupted(), name="interrupted"))
        self.assertIn("interrupted at t =", BROWSER.find("#verdicts").text)
        self.expect_plays()
        self.opened(RUNS.report(RUNS.killed(), name="killed"))
        self.assertIn("it is running, or was killed", BROWSER.find("#verdicts").text)
        self.expect_plays()

    def test_two_runs_lie_on_top_of_each_other(self):
        self.opened(RUNS.report(RUNS.coupled(), RUNS.stiffer(), name="two"))
        self.expect_all("two")
        both = self.expect_drawn()
        BROWSER.do("[...document.querySelectorAll('#controls label')].find((l) => l.textContent.includes('stiffer')).querySelector('input').click()")
        self.assertNotEqual(self.expect_drawn()["sum"], both["sum"])
        labels = BROWSER.do("return cosurge.charts[0].plot.series.map((s) => s.label).join()")
        self.assertIn("coupled, x", labels)
        self.assertIn("stiffer, x", labels)

    def test_published_curves(self):
        case = RUNS.case("referenced", (RUNS.small / "case.toml").read_text().replace("end    = 0.2", "end    = 0.02"))
        (case / "reference").mkdir(exist_ok=True)
        (case / "reference/somebody_2005.csv").write_text("t_s,ux_m\n0,0\n0.01,0.001\n0.02,0.003\n")
        self.opened(RUNS.report(RUNS.run(case, "referenced"), name="referenced"))
        BROWSER.wait("return cosurge.charts[0].plot", 10, "the first chart")
        self.assertIn("Somebody 2005, x", BROWSER.do("return cosurge.charts[0].plot.series.map((s) => s.label)"))

    def test_the_picture_of_a_case(self):
        page = RUNS.folder / "picture.html"
        page.unlink(missing_ok=True)
        RUNS.cosurge_says("check", RUNS.folder / "wave_case" if RUNS.water() else "", "--picture", page)
        self.opened(page)
        BROWSER.screenshot("picture")
        self.expect_drawn(colors=2)
        kinds = BROWSER.do("return cosurge.runs[0].scene.outlines.map((part) => part.kind)")
        for kind in ("tank", "water", "obstacle", "probe", "extreme", "path"):
            self.assertIn(kind, kinds)

    def test_a_run_that_goes_on(self):
        case = RUNS.case("long", (RUNS.small / "case.toml").read_text().replace("frame_interval = 0.02", "frame_interval = 0.005"))
        run = subprocess.Popen(RUNS.command(case, "watched"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not (RUNS.folder / "watched/checkpoint").exists():
            self.assertIsNone(run.poll())
        watch = subprocess.Popen([str(RUNS.cosurge), "watch", str(RUNS.folder / "watched")], stdout=subprocess.PIPE, text=True)
        try:
            address = re.search(r"http://\S+", watch.stdout.readline()).group()
            self.assertRegex(address, r"^http://127\.0\.0\.1:\d+/[0-9a-f]{32}/$")
            self.opened(address)
            begun = BROWSER.do("return cosurge.player.end")
            BROWSER.wait("return / left/.test(document.querySelector('#live').textContent)", 60, "the time that is left")
            BROWSER.wait(f"return cosurge.player.end > {begun}", 60, "more frames")
            self.expect_drawn()
            self.assertEqual(run.wait(300), 0)
            BROWSER.wait("return /finished/.test(document.querySelector('#live').textContent)", 30, "the end of the run")
            self.assertEqual(BROWSER.do("return cosurge.runs[0].members.fluid.filter(Boolean).length"), 41)
            port = int(address.split(":")[2].split("/")[0])
            for guess in ("", "0" * 32 + "/", "0" * 32 + "/run/0"):
                with self.assertRaises(urllib.error.HTTPError) as refused:
                    urllib.request.urlopen(f"http://127.0.0.1:{port}/{guess}")
                self.assertEqual(refused.exception.code, 404)
            listening = [line.split()[1] for line in Path("/proc/net/tcp").read_text().splitlines()[1:]
                         if line.split()[3] == "0A" and line.split()[1].endswith(f":{port:04X}")]
            self.assertEqual(listening, [f"0100007F:{port:04X}"], "it listens on other addresses, too")
        finally:
            watch.terminate()
            self.assertEqual(watch.wait(30), 0)
            watch.stdout.close()
            BROWSER.wait("return /no answer/.test(document.querySelector('#live').textContent)", 30, "word that the server is gone")
            self.assertTrue(all("ERR_CONNECTION_REFUSED" in error for error in BROWSER.errors()))
            BROWSER.driver.get("about:blank")
            if run.poll() is None:
                run.kill()

    def test_size_and_speed(self):
        """A page is as large as it may be; it opens and plays fast where the processor draws (slow machines are busy)."""
        folder = RUNS.coupled()
        page = RUNS.folder / "little.html"
        page.unlink(missing_ok=True)
        whole = RUNS.report(folder, name="whole").stat().st_size
        RUNS.cosurge_says("report", folder, "--size", "0.5", "--out", page)
        self.assertLess(page.stat().st_size, whole + 1)
        seconds = self.opened(page)
        BROWSER.do("cosurge.player.set(0); cosurge.player.frames = 0; window.begun = performance.now(); cosurge.player.play()")
        BROWSER.wait("return performance.now() - window.begun > 3000", 30, "three seconds")
        rate = BROWSER.do("return cosurge.player.frames / (performance.now() - window.begun) * 1000")
        print(f"opens in {seconds:.2f} s, plays {rate:.0f} frames a second")
        self.assertLess(seconds, 5)
        self.assertGreater(rate, 10)


if __name__ == "__main__":
    require_browser()
    programs, source = (Path(argument).resolve() for argument in sys.argv[1:3])
    with tempfile.TemporaryDirectory(prefix="cosurge-browser-") as folder:
        RUNS = Runs(programs, source, Path(folder))
        BROWSER = Browser()
        try:
            result = unittest.main(argv=sys.argv[:1] + sys.argv[3:], exit=False, verbosity=2).result
        finally:
            BROWSER.close()
    sys.exit(0 if result.wasSuccessful() else 1)
