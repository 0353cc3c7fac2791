"""The form as a web page in a real browser: form_in_browser.py TACTUS CHROMIUM.

A nurse answers some items with keys and pointer, the page is loaded again and has kept them, she finishes, and the answer
file goes into the study twice. Chromium is driven over a pipe (DevTools protocol), so nothing but Python is needed.
"""
import base64
import glob
import json
import os
import subprocess
import sys
import tempfile
import time


class Browser:
    """Chromium without a window; `call` sends one command and returns its result."""

    def __init__(self, program, folder):
        commands_out, self.commands = os.pipe()
        self.answers, answers_in = os.pipe()

        def pipes():
            ends = os.dup(commands_out), os.dup(answers_in)
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        self.process = subprocess.Popen(
            [program, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--lang=en",
             "--remote-debugging-pipe", "--user-data-dir=" + folder, "about:blank"],
            preexec_fn=pipes, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(commands_out)
        os.close(answers_in)
        self.count, self.waiting, self.requests, self.complaints, self.session = 0, b"", [], [], None

    def call(self, method, **params):
        self.count += 1
        message = {"id": self.count, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.waiting:
                more = os.read(self.answers, 1 << 20)
                if not more:
                    sys.exit("the browser ended")
                self.waiting += more
            one, self.waiting = self.waiting.split(b"\0", 1)
            message = json.loads(one)
            if message.get("id") == self.count:
                if "error" in message:
                    raise RuntimeError(method + ": " + json.dumps(message["error"]))
                return message["result"]
            self.note(message)

    def note(self, event):
        params = event.get("params", {})
        if event.get("method") == "Network.requestWillBeSent":
            self.requests.append(params["request"]["url"])
        if event.get("method") == "Runtime.exceptionThrown":
            self.complaints.append(json.dumps(params["exceptionDetails"])[:500])
        if event.get("method") == "Log.entryAdded" and params["entry"]["level"] == "error":
            self.complaints.append(params["entry"]["text"])

    def open(self, url):
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(domain + ".enable")
        self.call("Page.navigate", url=url)
        self.wait_for("document.querySelector('#app h1') !== null")

    def js(self, code):
        result = self.call("Runtime.evaluate", expression=code, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(code + ": " + json.dumps(result["exceptionDetails"])[:500])
        return result["result"].get("value")

    def wait_for(self, code):
        for _ in range(200):
            if self.js(code):
                return
            time.sleep(0.05)
        raise RuntimeError("never true: " + code)

    def click(self, selector):
        self.js("document.querySelector(%s).click()" % json.dumps(selector))

    def key(self, key):
        text = "\r" if key == "Enter" else key
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, text=text,
                  windowsVirtualKeyCode=13 if key == "Enter" else ord(key))
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def title(self):
        return self.js("document.querySelector('#app h1').textContent")

    def reload(self):
        self.js("window.before_reload = true")
        self.call("Page.reload")
        self.wait_for("!window.before_reload && document.querySelector('#app h1') !== null")


def same(found, wanted, what):
    if found != wanted:
        sys.exit("%s: found %r, wanted %r" % (what, found, wanted))


def tactus(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True)


def said(program, *arguments):
    run = tactus(program, *arguments)
    if run.returncode != 0:
        sys.exit(" ".join(arguments) + ": " + run.stderr)
    return run.stdout


def make_form(program, folder):
    study, form = folder + "/a.tactus", folder + "/form"
    said(program, "study", "new", study)
    consent = []
    for language in ("en", "zh-Hant", "zh-Hans"):
        path = folder + "/" + language + ".txt"
        with open(path, "w", encoding="utf-8") as out:
            out.write("The study of </script> & \"quotes\".\n")
        consent += ["--consent", language + "=" + path]
    said(program, "study", "protocol", study, "--set", "languages=en,zh-Hant,zh-Hans", "--set", "consent_version=3",
         "--set", "contact=Dr. Lee", *consent, "--author", "Test")
    said(program, "study", "form", study, "--to", "web", "--out", form)
    return study, form + "/form.html"


def check_names(browser):
    """Every field has a name that a screen reader says, every group a legend, every picture a text."""
    same(browser.js("""Array.from(document.querySelectorAll('#app input, #app select, #app textarea')).filter(
        (one) => !one.labels.length && !one.getAttribute('aria-label') && !one.getAttribute('aria-labelledby')).length"""),
         0, browser.title() + ": fields without a name")
    same(browser.js("""Array.from(document.querySelectorAll('#app fieldset')).filter(
        (one) => !one.querySelector('legend').textContent.trim()).length"""), 0, browser.title() + ": groups without a legend")
    same(browser.js("document.querySelectorAll('#app svg[role=img]:not([aria-label])').length"), 0, "pictures without a text")
    same(browser.js("document.documentElement.scrollWidth <= window.innerWidth"), True, browser.title() + ": fits the width")


def answer(browser):
    browser.click("section.panel button.primary")
    same(browser.title(), "Your consent", "screen")
    same("</script> & \"quotes\"" in browser.js("document.querySelector('.consent').textContent"), True, "the study's text")
    check_names(browser)
    browser.click(".foot .primary")
    check_names(browser)
    browser.click(".foot .primary")
    same(browser.js("!document.querySelector('.error').hidden"), True, "a sentence says what is missing")
    for field, value in (("years", "years_3"), ("handedness", "left"), ("gloves", "none"), ("haptic_experience", "not_say")):
        browser.click("input[name=%s][value=%s]" % (field, value))
    browser.click(".foot .primary")
    check_names(browser)
    browser.click(".foot .primary")
    check_names(browser)
    browser.key("4")
    browser.key("Enter")
    same(browser.title(), "Question 2 of 45", "after two keys")
    browser.key("0")
    browser.key("Enter")
    browser.click("input[value=small]")
    browser.click(".foot .primary")
    browser.click(".foot .secondary")  # back: another word for the third
    browser.click("input[value=very_large]")
    browser.click(".foot .primary")
    browser.click(".skip")
    same(browser.title(), "Question 5 of 45", "after a skipped one")


def finish(browser):
    """From where the page stands after it was loaded again."""
    same(browser.title(), "Welcome", "first screen")
    same("kept your 3 answers" in browser.js("document.querySelector('.panel h2').textContent"), True, "kept answers")
    browser.click("section.panel .primary")
    same(browser.title(), "Question 5 of 45", "where she was")
    browser.js("(() => { const one = document.getElementById('language'); one.value = 'zh-Hant';"
               "one.dispatchEvent(new Event('change')); })()")
    same(browser.js("document.documentElement.lang"), "zh-Hant", "language of the page")
    for item in range(5, 46):
        same(browser.js("document.querySelector('input[name=answer]') !== null"), True, "item %d" % item)
        browser.key("3")
        browser.key("Enter")
    same(browser.js("document.querySelectorAll('.cell').length"), 45, "cells of the review")
    same(browser.js("document.querySelectorAll('.cell.open').length"), 1, "open cells")
    browser.click(".foot .primary")
    browser.click("#teach")
    check_names(browser)
    browser.js("document.querySelectorAll('input[value=\"6\"]').forEach((one) => one.click())")
    browser.click(".foot .primary")


def main():
    program, chromium = sys.argv[1], sys.argv[2]
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        study, form = make_form(program, folder)
        browser = Browser(chromium, folder + "/profile")
        try:
            browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=folder)
            browser.open("file://" + form)
            browser.call("Emulation.setDeviceMetricsOverride", width=360, height=740, deviceScaleFactor=1, mobile=True)
            answer(browser)
            browser.reload()
            finish(browser)
            code = browser.js("document.getElementById('check-code').textContent")
            browser.click("#save")
            for _ in range(200):
                saved = glob.glob(folder + "/*.tactus-answers.json")
                if saved:
                    break
                time.sleep(0.05)
            else:
                sys.exit("no answer file was saved")
            time.sleep(0.2)
            paper = base64.b64decode(browser.call("Page.printToPDF", preferCSSPageSize=True)["data"])
            same(paper.count(b"/Type /Page\n") + paper.count(b"/Type /Page "), 11, "pages on paper")
            browser.js("setTimeout(() => document.querySelector('#delete').click())")  # a dialog stops what waits for it
            time.sleep(0.3)
            browser.call("Page.handleJavaScriptDialog", accept=True)
            browser.wait_for("document.querySelector('.screen-deleted') !== null")
            same(browser.js("localStorage.length === 1 && !localStorage.getItem(localStorage.key(0)).includes('answered')"),
                 True, "nothing is kept of who deletes her answers")
            browser.call("Page.addScriptToEvaluateOnNewDocument", source="""Object.defineProperty(window, 'localStorage',
                {get() { throw new Error('refused'); }})""")
            browser.reload()
            same(browser.js("document.getElementById('storage').classList.contains('notice')"), True,
                 "the page says that the browser keeps nothing")
            strangers = [url for url in browser.requests if not url.startswith(("file:", "data:", "blob:"))]
            same(strangers, [], "requests")
            same(browser.complaints, [], "errors of the page")
            browser.call("Browser.close")
        finally:
            browser.process.terminate()
            browser.process.wait()

        with open(saved[0], encoding="utf-8") as file:
            answers = json.load(file)
        same(answers["check_code"], code, "check code in the file and on the page")
        same([one["status"] for one in answers["answers"][:5]],
             ["answered", "cant_tell", "answered", "skipped", "answered"], "statuses")
        same((answers["answers"][2]["term"], answers["answers"][2]["changes"]), ("very_large", 1), "a changed answer")
        first = json.loads(said(program, "study", "import", study, saved[0], "--json"))
        same((first["persons"], first["sessions"], first["answers"][0]["added"]), (1, 2, True), "first import")
        again = json.loads(said(program, "study", "import", study, saved[0], "--json"))
        same((again["persons"], again["sessions"], again["records"], again["answers"][0]["added"]), (0, 0, 0, False),
             "second import")
        check = json.loads(said(program, "study", "check", study, "--json"))
        same(check["findings"], [], "findings")
        answers["answers"][0]["term"] = "small"
        with open(saved[0], "w", encoding="utf-8") as file:
            json.dump(answers, file)
        changed = tactus(program, "study", "import", study, saved[0])
        same((changed.returncode, "check_code" in changed.stderr), (1, True), "a file that was changed")


main()
