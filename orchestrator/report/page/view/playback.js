/** Frames are played so many times slower than the mill turns. */
const slowedDown = 10;

/** Time from the first frame [s], played in a loop: advance(now [ms]) after each picture. */
function playbackOf(duration) {
  const playback = {time: 0, playing: false, duration, before: null};
  playback.advance = (now) => {
    if (!playback.playing) { playback.before = null; return; }
    const passed = playback.before === null ? 0 : Math.min(now - playback.before, 100) / 1e3;
    playback.time = (playback.time + passed / slowedDown) % duration;
    playback.before = now;
  };
  return playback;
}

/** A button that plays and pauses and a slider of the time; `show` follows what happens without them. */
function playbackControls(playback, changed) {
  const button = element("button", {type: "button"}, "Play");
  const slider = element("input", {type: "range", min: 0, max: playback.duration, step: playback.duration / 200, value: 0,
    "aria-label": "Time"});
  const said = element("span", {});
  const show = () => {
    const words = fixed(3)(playback.time) + " s";
    slider.value = playback.time;
    if (said.textContent !== words) said.textContent = words;
    slider.setAttribute("aria-valuetext", words);
  };
  const play = (playing) => {
    playback.playing = playing;
    button.textContent = playing ? "Pause" : "Play";
    changed();
  };
  button.addEventListener("click", () => play(!playback.playing));
  slider.addEventListener("input", () => {
    playback.time = Number(slider.value);
    play(false);
  });
  show();
  return {parts: [element("span", {class: "control"}, button, slider, said)], show};
}
