"""A headless browser with a page of Cosurge, and what one does with it."""
import importlib.util
import os
import shutil
import sys
import time
from pathlib import Path

SKIPPED = 77  # for ctest: SKIP_RETURN_CODE


def require_browser():
    """Ends the test as skipped where there is no browser that can be driven."""
    missing = [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]
    if importlib.util.find_spec("selenium") is None:
        missing.append("selenium of Python")
    if missing:
        print(f"skipped: no {', no '.join(missing)} here (Debian: chromium chromium-driver python3-selenium)")
        sys.exit(SKIPPED)


class Browser:
    def __init__(self, width=1280, height=1300):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
        options = webdriver.ChromeOptions()
        options.binary_location = shutil.which("chromium")
        for argument in ("--headless=new", "--no-sandbox", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage",
                         "--hide-scrollbars", f"--window-size={width},{height}"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)

    def close(self):
        self.driver.quit()

    def do(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def find(self, selector):
        return self.driver.find_element("css selector", selector)

    def open(self, page):
        """Returns the seconds until the whole page stands."""
        begin = time.monotonic()
        self.driver.get(page.resolve().as_uri() if isinstance(page, Path) else page)
        self.wait("return document.documentElement.dataset.ready === 'yes'", 60, "the page to be ready")
        return time.monotonic() - begin

    def wait(self, condition, seconds, what):
        end = time.monotonic() + seconds
        while not self.do(condition):
            if time.monotonic() > end:
                raise AssertionError(f"waited {seconds} s for {what}; trouble: {self.trouble()}; console: {self.errors()}")
            time.sleep(0.05)

    def trouble(self):
        return self.do("const t = document.querySelector('#trouble'); return t && !t.hidden ? t.textContent : ''")

    def errors(self):
        """What the console has of errors since the last call, and of requests to anywhere else than the page's own place."""
        return [entry["message"] for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def colors(self):
        """Number of pixels of the scene that are not white, and of different colours among them."""
        return self.do("""
            const {scene} = cosurge, {gl} = scene, w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
            scene.draw();
            const pixels = new Uint8Array(4 * w * h), seen = new Set();
            gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
            let drawn = 0, sum = 0;
            for (let k = 0; k < pixels.length; k += 4) {
              const color = pixels[k] << 16 | pixels[k + 1] << 8 | pixels[k + 2];
              if (color === 0xffffff) continue;
              ++drawn;
              seen.add(color);
              sum = (sum * 31 + color * (k % 9973)) % 2147483647;
            }
            return {drawn, colors: seen.size, sum};""")

    def scrub(self, share):
        """Moves the slider to a share of the run."""
        self.do("""const s = document.querySelector('.slider'); s.value = 1000 * arguments[0];
                   s.dispatchEvent(new Event('input', {bubbles: true}));""", share)

    def mouse(self):
        from selenium.webdriver.common.action_chains import ActionChains
        return ActionChains(self.driver, duration=50)

    def screenshot(self, name):
        """Keeps a picture where the environment names a folder for them."""
        folder = os.environ.get("COSURGE_SCREENSHOTS")
        if folder:
            self.driver.save_screenshot(str(Path(folder) / f"{name}.png"))
