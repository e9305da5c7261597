"""A headset is offered where the browser has one, and shows the trial to both eyes.

No headset is at hand: `navigator.xr` is a stand-in that keeps the rules of WebXR as far as the page
uses them. Whether the picture is comfortable nobody has seen.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import omnistudy
from omnistudy.view.chromium import Browser, Tab
from omnistudy.view.film import film
from omnistudy.view.page import replay_page, write_page

HEADSET = """
Object.defineProperty(navigator, 'xr', {value: {
  isSessionSupported: async (kind) => kind === 'immersive-vr',
  requestSession: async (kind) => { window.asked = kind; return window.headset = new Headset(); },
}});
class Headset extends EventTarget {
  frames = []; renderState = {}; enabledFeatures = ['local-floor']; inputSources = [];
  updateRenderState(state) { Object.assign(this.renderState, state); }
  async requestReferenceSpace(kind) { this.space = kind; return {}; }
  requestAnimationFrame(next) { return this.frames.push(next); }
  cancelAnimationFrame() { this.frames = []; }
  async end() { this.dispatchEvent(new Event('end')); }
  /** A picture of a head 1.2 m above the floor that looks ahead, with eyes 64 mm apart. */
  show(now) {
    const view = (eye) => ({
      eye: eye < 0 ? 'left' : 'right',
      projectionMatrix: new Float32Array([1,0,0,0, 0,1,0,0, 0,0,-1,-1, 0,0,-0.2,0]),
      transform: {matrix: new Float32Array([1,0,0,0, 0,1,0,0, 0,0,1,0, 0.032 * eye,1.2,0,1])},
    });
    const frame = {session: this, getViewerPose: () => ({views: [view(-1), view(1)]})};
    for (const next of this.frames.splice(0)) next(now, frame);
  }
}
window.XRWebGLLayer = class {
  framebuffer = null; framebufferWidth = 640; framebufferHeight = 320;
  getViewport(view) { return {x: view.eye === 'left' ? 0 : 320, y: 0, width: 320, height: 320}; }
};
delete window.XRWebGLBinding;
WebGL2RenderingContext.prototype.makeXRCompatible = async () => undefined;
"""
BUTTON = "document.querySelector('.enter')"
PLAYER = "window.replay.player"
EYES = """(() => {
  const {renderer} = window.replay.player.reels[0].stage;
  const eyes = renderer.xr.getCamera().cameras;
  return eyes.map((eye) => Array.from(eye.matrixWorld.elements));
})()"""


@pytest.fixture(scope="module")
def page(driven_study: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("immersive") / "trial.html"
    with omnistudy.open(driven_study) as study:
        write_page(replay_page([film(study, 1)]), file)
    return file


def shown(chromium: Browser, page: Path, before: str) -> Tab:
    tab = chromium.tab(900, 700)
    tab.ask("Page.addScriptToEvaluateOnNewDocument", source=before)
    tab.open(f"{page.as_uri()}#t=3&camera=first")
    tab.wait_for("window.replay !== undefined")
    return tab


@pytest.mark.slow
def test_without_a_headset_there_is_no_way_in(chromium: Browser, page: Path) -> None:
    tab = shown(chromium, page, "")
    assert tab.value(f"{BUTTON}.hidden")
    none = (
        "Object.defineProperty(navigator, 'xr', {value: {isSessionSupported: async () => false}})"
    )
    tab = shown(chromium, page, none)
    assert tab.value(f"{BUTTON}.hidden")
    assert tab.faults == []


@pytest.mark.slow
def test_both_eyes_stand_at_the_robot_and_look_where_it_does(chromium: Browser, page: Path) -> None:
    tab = shown(chromium, page, HEADSET)
    tab.wait_for(f"!{BUTTON}.hidden")
    assert tab.value(f"{BUTTON}.textContent") == "Enter VR"
    tab.ask("Runtime.evaluate", expression=f"{BUTTON}.click()", userGesture=True)
    tab.wait_for("window.headset?.frames.length === 1")
    assert (tab.value("window.asked"), tab.value("window.headset.space")) == (
        "immersive-vr",
        "local-floor",
    )
    for now in (1000, 1016):
        tab.value(f"window.headset.show({now})")
    left, right = (np.array(eye).reshape(4, 4).T for eye in tab.value(EYES))
    robot = tab.value(
        f"(() => {{ const m = {PLAYER}.reels[0].record.at(3); return [m.x, m.y]; }})()"
    )
    between = 0.5 * (left[:3, 3] + right[:3, 3])
    assert between[2] == pytest.approx(1.2)
    assert np.hypot(*(between[:2] - robot)) == pytest.approx(0.1, abs=1e-3), "as the first person"
    assert np.linalg.norm(right[:3, 3] - left[:3, 3]) == pytest.approx(0.064)
    assert left[:3, 1] == pytest.approx([0.0, 0.0, 1.0], abs=1e-6), "up is up"
    ahead = -left[:2, 2]
    assert ahead @ (np.array(robot) - between[:2]) == pytest.approx(0.1, abs=5e-3)
    before = tab.value(f"{PLAYER}.t")
    tab.value("window.headset.dispatchEvent(new Event('select'))")
    tab.value("window.headset.show(performance.now() + 500)")
    assert tab.value(f"{PLAYER}.t") > before + 0.4, "the trigger plays"
    tab.value("window.headset.dispatchEvent(new Event('select'))")
    assert not tab.value(f"{PLAYER}.playing")
    tab.value(f"{BUTTON}.click()")
    assert tab.value(f"{BUTTON}.textContent") == "Enter VR"
    tab.value("window.replay.seek(5)")
    assert tab.value(f"{PLAYER}.t") == 5
    assert tab.faults == []
