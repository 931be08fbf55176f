/** Uploads the mesh of a sector; returns draw(uniforms). */
function linerDrawing(gl, program, mesh) {
  const vertices = gl.createVertexArray();
  gl.bindVertexArray(vertices);
  filledBuffer(gl, mesh);
  for (const location of [0, 1]) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 24, 12 * location);
  }
  return (uniforms) => {
    useProgram(gl, program, {...uniforms, pitch: 2 * Math.PI / data.sector.rows});
    gl.bindVertexArray(vertices);
    gl.enable(gl.CULL_FACE);
    gl.drawArraysInstanced(gl.TRIANGLES, 0, mesh.length / 6, data.sector.rows);
    gl.disable(gl.CULL_FACE);
  };
}

/** Uploads the particles of all frames; returns draw(uniforms, the first frame of the interval). */
function sphereDrawing(gl, program, frames, turning) {
  const vertices = gl.createVertexArray();
  gl.bindVertexArray(vertices);
  filledBuffer(gl, frames.radii);
  gl.vertexAttribPointer(2, 1, gl.FLOAT, false, 0, 0);
  filledBuffer(gl, frames.classes);
  gl.vertexAttribIPointer(3, 1, gl.UNSIGNED_BYTE, 0, 0);
  const places = filledBuffer(gl, frames.places);
  for (const location of [0, 1, 2, 3]) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribDivisor(location, 1);
  }
  return (uniforms, interval) => {
    useProgram(gl, program, {...uniforms, turning, slip: slipWithMill(turning), low: frames.low, slice: data.charge.slice_length});
    gl.bindVertexArray(vertices);
    gl.bindBuffer(gl.ARRAY_BUFFER, places);
    for (const location of [0, 1])
      gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 0, 12 * frames.particles * (interval + location));
    gl.enable(gl.SAMPLE_ALPHA_TO_COVERAGE);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, frames.particles);
    gl.disable(gl.SAMPLE_ALPHA_TO_COVERAGE);
  };
}

/** A texture of 256 colours; returns fill(bytes red, green, blue, 255 of each). */
function paletteTexture(gl) {
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
  return (bytes) => gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
}

/** Red, green and blue from 0 to 1 of a computed colour. */
const shares = (colour) => { const {r, g, b} = d3.rgb(colour); return [r / 255, g / 255, b / 255]; };

/**
 * What a canvas shows: draw(charge of a cycle, time [s], camera, colouring). Null without WebGL 2.
 * A lost context loses all of it; then a new scene is made.
 */
function chargeScene(canvas) {
  const gl = canvas.getContext("webgl2", {alpha: false});
  if (!gl) return null;
  const [spheres, liner] = [sphereShaders, linerShaders].map((shaders) => linkedProgram(gl, shaders));
  if (!spheres || !liner) return null;
  const fillPalette = paletteTexture(gl);
  const uploaded = new Map();
  const drawingsOf = (one) => {
    if (!uploaded.has(one))
      uploaded.set(one, {drawLiner: linerDrawing(gl, liner, one.mesh()), drawSpheres: sphereDrawing(gl, spheres, one.frames(), one.charge.speed)});
    return uploaded.get(one);
  };
  gl.enable(gl.DEPTH_TEST);
  return {draw(one, time, camera, colouring) {
    const {drawLiner, drawSpheres} = drawingsOf(one);
    const frames = one.frames();
    const {interval, duration, share} = intervalAt(frames, time);
    const [from, to] = frames.millAngles.slice(interval, interval + 2);
    const style = getComputedStyle(canvas);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(...shares(style.backgroundColor), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const seen = cameraUniforms(camera, canvas.width / canvas.height);
    drawLiner({...seen, millAngle: from + share * (to - from), colour: shares(style.color)});
    fillPalette(colouring.palette(data));
    const pixel = 2 / (focalLength * canvas.height);
    drawSpheres({...seen, share, duration, pixel, colouring: colouring.entry, fast: colouring.fast}, interval);
  }};
}
