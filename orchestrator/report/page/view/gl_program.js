/** Compiles and links {vertex, fragment}: {handle, uniforms: by name their place and type}; null where the driver refuses. */
function linkedProgram(gl, {vertex, fragment}) {
  const handle = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(handle, shader);
  }
  gl.linkProgram(handle);
  if (!gl.getProgramParameter(handle, gl.LINK_STATUS)) {
    console.error(gl.getProgramInfoLog(handle));
    return null;
  }
  const uniforms = d3.range(gl.getProgramParameter(handle, gl.ACTIVE_UNIFORMS)).map((i) => gl.getActiveUniform(handle, i))
    .map(({name, type}) => [name, {type, place: gl.getUniformLocation(handle, name)}]);
  return {handle, uniforms: new Map(uniforms)};
}

/** Makes a program the one in use and sets its uniforms {name: number, or array of numbers}. */
function useProgram(gl, {handle, uniforms}, values) {
  gl.useProgram(handle);
  const setters = {[gl.FLOAT]: "uniform1f", [gl.INT]: "uniform1i", [gl.FLOAT_VEC3]: "uniform3fv", [gl.FLOAT_VEC4]: "uniform4fv"};
  for (const [name, {type, place}] of uniforms)
    if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(place, false, values[name]);
    else if (type !== gl.SAMPLER_2D) gl[setters[type]](place, values[name]);
}

function filledBuffer(gl, values) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  return buffer;
}
