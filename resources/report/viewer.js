// SPDX-License-Identifier: GPL-3.0-or-later
// The view to turn of a report page. Shading follows the program's own pictures, so that both look alike.
(function () {
'use strict';

const byId = (id) => document.getElementById(id);
const viewer = byId('viewer'), stage = viewer.querySelector('.stage'), message = byId('message');

// Pictures open large on a click.
document.querySelectorAll('figure img').forEach((img) => img.addEventListener('click', () => {
  const dialog = document.createElement('dialog');
  const large = document.createElement('img');
  large.src = img.src;
  large.alt = img.alt;
  dialog.append(large);
  dialog.addEventListener('click', () => dialog.close());
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}));

function makeContext(canvas) {
  try {
    return canvas.getContext('webgl', { antialias: true, alpha: true }) || null;
  } catch (e) {
    return null;
  }
}

const canvas = document.createElement('canvas');
canvas.tabIndex = 0;
canvas.setAttribute('aria-label', 'The surface, to be turned with the mouse');
const context = makeContext(canvas);
if (!context || !context.getExtension('OES_standard_derivatives')) {
  message.textContent = 'This browser has no WebGL, so there is no model to turn; the pictures below show the same.';
  viewer.dataset.state = 'no-webgl';
  return;
}

const scene = JSON.parse(byId('scene').textContent);
const THREE = window.THREE;

function bytes(text) {
  const raw = atob(text), array = new Uint8Array(raw.length);
  for (let k = 0; k < raw.length; ++k) array[k] = raw.charCodeAt(k);
  return array.buffer;
}
const floats = (text) => new Float32Array(bytes(text));

// Normals at vertices; those along creases are doubled in the data.
function normals(positions, index) {
  const sum = new Float32Array(positions.length);
  for (let t = 0; t < index.length; t += 3) {
    const [a, b, c] = [3 * index[t], 3 * index[t + 1], 3 * index[t + 2]];
    const corner = [a, b, c];
    const e = [0, 1, 2].map((k) => [0, 1, 2].map((i) => positions[corner[(k + 1) % 3] + i] - positions[corner[k] + i]));
    const n = [e[0][1] * -e[2][2] + e[0][2] * e[2][1], e[0][2] * -e[2][0] + e[0][0] * e[2][2], e[0][0] * -e[2][1] + e[0][1] * e[2][0]];
    const area = Math.hypot(n[0], n[1], n[2]);
    if (area > 0) {
      for (let k = 0; k < 3; ++k) {
        const u = e[k], v = e[(k + 2) % 3];
        const angle = Math.atan2(area, -(u[0] * v[0] + u[1] * v[1] + u[2] * v[2]));
        for (let i = 0; i < 3; ++i) sum[corner[k] + i] += angle * n[i] / area;
      }
    }
  }
  for (let k = 0; k < sum.length; k += 3) {
    const length = Math.hypot(sum[k], sum[k + 1], sum[k + 2]) || 1;
    for (let i = 0; i < 3; ++i) sum[k + i] /= length;
  }
  return sum;
}

const vertexShader = `
attribute vec3 moved;
attribute vec3 movedNormal;
attribute float gaussBefore;
attribute float gaussAfter;
attribute float bulge;
uniform float blend;
uniform float bulgeRange;
uniform float slideRange;
uniform int mode;
varying vec3 vNormal;
varying vec3 vColour;
varying vec3 vRest;
vec3 ramp(float x) {
  vec3 end = x < 0.0 ? vec3(0.13, 0.35, 0.76) : vec3(0.78, 0.16, 0.14);
  return mix(vec3(0.96, 0.96, 0.95), end, pow(clamp(abs(x), 0.0, 1.0), 0.8));
}
vec3 signColour(float s) {
  if (s > 1.5) return vec3(0.80, 0.81, 0.82);
  return s > 0.5 ? vec3(0.84, 0.36, 0.32) : (s < -0.5 ? vec3(0.30, 0.50, 0.84) : vec3(0.62, 0.63, 0.64));
}
void main() {
  vRest = position;
  vNormal = normalMatrix * mix(normal, movedNormal, blend);
  vColour = vec3(0.60, 0.66, 0.72);
  if (mode == 2) vColour = ramp(blend * length(moved - position) / max(slideRange, 1e-12));
  if (mode == 3) vColour = ramp(blend * bulge / max(bulgeRange, 1e-12));
  if (mode == 4) vColour = signColour(blend < 0.5 ? gaussBefore : gaussAfter);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(mix(position, moved, blend), 1.0);
}`;

const fragmentShader = `
uniform int mode;
uniform float period;
uniform vec3 half_;
varying vec3 vNormal;
varying vec3 vColour;
varying vec3 vRest;
float mattLight(vec3 n) {
  float wrapped = max(0.0, (dot(n, normalize(vec3(-0.55, 0.70, 0.60))) + 0.3) / 1.3);
  float side = max(0.0, dot(n, normalize(vec3(0.90, 0.05, 0.35))));
  return 0.15 + 0.14 * (0.5 + 0.5 * n.y) + 0.60 * wrapped * wrapped + 0.26 * side * side;
}
float reflectionAngle(vec3 n) {
  vec3 across = vec3(-0.34202014, 0.93969262, 0.0);
  vec3 ray = 2.0 * n.z * n - vec3(0.0, 0.0, 1.0);
  return degrees(atan(dot(ray, across), ray.z));
}
float gloss(vec3 n) {
  vec3 h = normalize(normalize(vec3(-0.5, 0.75, 0.65)) + vec3(0.0, 0.0, 1.0));
  float studio = 0.5 + 0.5 * cos((reflectionAngle(n) - 62.0) / 38.0 * 3.14159265);
  return 0.10 * pow(max(0.0, dot(n, h)), 48.0) + 0.10 * pow(1.0 - clamp(n.z, 0.0, 1.0), 4.0) + 0.13 * studio * studio;
}
void main() {
  if (any(greaterThan(abs(vRest), half_))) discard;
  if (mode == 9) { gl_FragColor = vec4(0.10, 0.13, 0.18, 0.35); return; }
  vec3 n = normalize(vNormal);
  bool front = gl_FrontFacing;
  if (n.z < 0.0) n = -n;
  vec3 c;
  if (mode == 1) {
    float turn = reflectionAngle(n) / period;
    float wave = abs(fract(turn + 0.5) - 0.5);
    float edge = max(fwidth(turn), 0.02);
    float light = clamp((0.25 - wave) / edge + 0.5, 0.0, 1.0);
    light = mix(light, 0.5, clamp(2.0 * fwidth(turn) - 1.0, 0.0, 1.0));
    c = vec3((0.035 + 0.86 * light) * (0.72 + 0.30 * mattLight(n)) + 0.05 * gloss(n));
  } else if (mode == 0) {
    c = pow(front ? vColour : vec3(0.66, 0.58, 0.50), vec3(2.2)) * 1.5 * mattLight(n) + gloss(n);
  } else {
    c = pow(vColour, vec3(2.2)) * (0.55 + 0.55 * mattLight(n));
  }
  gl_FragColor = vec4(pow(c, vec3(1.0 / 2.2)), 1.0);
}`;

const renderer = new THREE.WebGLRenderer({ canvas: canvas, context: context, antialias: true, alpha: true });
renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
renderer.setClearColor(0x000000, 0);

const uniforms = {
  blend: { value: 1 }, mode: { value: 0 }, period: { value: scene.zebra_period },
  half_: { value: new THREE.Vector3(scene.half[0], scene.half[1], scene.half[2]) },
  bulgeRange: { value: scene.bulge_range }, slideRange: { value: scene.slide_range }
};
function material(own, more) {
  return new THREE.ShaderMaterial(Object.assign({
    uniforms: Object.assign({}, uniforms, own), vertexShader: vertexShader, fragmentShader: fragmentShader,
    side: THREE.DoubleSide, extensions: { derivatives: true }
  }, more));
}
const surfaceMaterial = material({}, { polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
const meshMaterial = material({ mode: { value: 9 } }, { wireframe: true, transparent: true });

const world = new THREE.Scene();
const surface = new THREE.Mesh(new THREE.BufferGeometry(), surfaceMaterial);
const wires = new THREE.Mesh(surface.geometry, meshMaterial);
wires.visible = false;
const lineBefore = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x1a59bf }));
const lineAfter = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0xd91a1a }));
for (const object of [surface, wires, lineBefore, lineAfter]) {
  object.frustumCulled = false;
  world.add(object);
}
lineBefore.geometry.setAttribute('position', new THREE.BufferAttribute(floats(scene.line_before), 3));

const sheets = scene.sheets.map((data) => {
  const index = data.narrow ? new Uint16Array(bytes(data.index)) : new Uint32Array(bytes(data.index));
  if (!data.narrow) context.getExtension('OES_element_index_uint');
  const rest = floats(data.rest);
  return { index: index, rest: rest, restNormals: normals(rest, index), gauss: new Float32Array(new Int8Array(bytes(data.gauss_before))) };
});
const geometries = new Map();
function geometryOf(number) {
  if (!geometries.has(number)) {
    const result = scene.results[number], sheet = sheets[result.sheet], moved = floats(result.moved);
    const geometry = new THREE.BufferGeometry();
    const put = (name, array, size) => geometry.setAttribute(name, new THREE.BufferAttribute(array, size));
    geometry.setIndex(new THREE.BufferAttribute(sheet.index, 1));
    put('position', sheet.rest, 3);
    put('normal', sheet.restNormals, 3);
    put('moved', moved, 3);
    put('movedNormal', normals(moved, sheet.index), 3);
    put('gaussBefore', sheet.gauss, 1);
    put('gaussAfter', new Float32Array(new Int8Array(bytes(result.gauss_after))), 1);
    put('bulge', floats(result.bulge), 1);
    geometries.set(number, { geometry: geometry, line: floats(result.line) });
  }
  return geometries.get(number);
}

// The camera of the pictures.
const vector = (list) => new THREE.Vector3(list[0], list[1], list[2]);
const far = 20 * scene.size;
const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 2 * far);
camera.up.copy(vector(scene.camera.up));
const controls = new THREE.OrbitControls(camera, canvas);
controls.enableKeys = false;
controls.enableZoom = false;
controls.screenSpacePanning = true;
// The wheel scrolls the page until someone has taken hold of the model.
canvas.addEventListener('pointerdown', () => { controls.enableZoom = true; canvas.focus(); });
document.addEventListener('pointerdown', (event) => { if (event.target !== canvas) controls.enableZoom = false; });

// Looks as the pictures do, with all that is shown in sight.
const sight = (() => {
  const ahead = vector(scene.camera.direction).normalize();
  const right = new THREE.Vector3().crossVectors(ahead, vector(scene.camera.up)).normalize();
  const up = new THREE.Vector3().crossVectors(right, ahead);
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity], rest = sheets[0].rest;
  const point = new THREE.Vector3();
  for (let k = 0; k < rest.length; k += 3) {
    point.set(rest[k], rest[k + 1], rest[k + 2]);
    if (scene.half.every((h, i) => Math.abs(rest[k + i]) <= h)) {
      [right, up, ahead].forEach((axis, i) => {
        low[i] = Math.min(low[i], point.dot(axis));
        high[i] = Math.max(high[i], point.dot(axis));
      });
    }
  }
  const target = new THREE.Vector3();
  [right, up, ahead].forEach((axis, i) => target.addScaledVector(axis, (low[i] + high[i]) / 2));
  return { target: target, width: high[0] - low[0], height: high[1] - low[1] };
})();

function home() {
  controls.target.copy(sight.target);
  camera.position.copy(controls.target).addScaledVector(vector(scene.camera.direction), -far);
  camera.zoom = 1;
  camera.updateProjectionMatrix();
  controls.update();
}

function resize() {
  const width = stage.clientWidth, height = stage.clientHeight;
  if (width < 1 || height < 1) return;
  renderer.setSize(width, height, false);
  const half = 0.54 * Math.max(sight.height, sight.width * height / width);
  camera.top = half;
  camera.bottom = -half;
  camera.right = half * width / height;
  camera.left = -camera.right;
  camera.updateProjectionMatrix();
  draw();
}

let lineNow = null, lineFrom = floats(scene.line_before);
function draw() {
  if (lineNow) {
    const array = lineAfter.geometry.attributes.position.array, t = uniforms.blend.value;
    for (let k = 0; k < array.length; ++k) array[k] = lineFrom[k] + t * (lineNow[k] - lineFrom[k]);
    lineAfter.geometry.attributes.position.needsUpdate = true;
  }
  renderer.render(world, camera);
}

function choose(box, number) {
  [...box.children].forEach((button, k) => button.setAttribute('aria-pressed', String(k === number)));
}
function pill(box, text, act) {
  const button = document.createElement('button');
  button.type = 'button';
  button.textContent = text;
  const number = box.children.length;
  button.addEventListener('click', () => { act(number); choose(box, number); draw(); });
  box.append(button);
}
function show(number) {
  const chosen = geometryOf(number);
  surface.geometry = wires.geometry = chosen.geometry;
  lineNow = chosen.line;
  lineAfter.geometry.dispose();
  lineAfter.geometry = new THREE.BufferGeometry();
  lineAfter.geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(lineNow.length), 3));
}

const short = (x) => Math.abs(x) >= 100 ? x.toFixed(0) : Number(x.toPrecision(3)).toString();
const hint = '<span class="hint">Drag: turn. Right button: shift. Wheel, after a click: zoom.</span>';
const ramp = (from, to, left, right) =>
  `<span>${left}</span><i class="ramp" style="background:linear-gradient(to right,${from},${to})"></i><span>${right}</span>`;
const shadings = [
  ['Shaded', () => ''],
  ['Zebra', () => ''],
  ['Displacement', () => ramp('#f5f5f2', '#c72924', '0', short(scene.slide_range) + ' mm')],
  ['Off the old surface', () => ramp('#215ac2,#f5f5f2', '#c72924', '−' + short(scene.bulge_range), '+' + short(scene.bulge_range) + ' mm, one scale for all')],
  ['Gaussian sign', () => '<i class="field" style="background:#d65c52"></i>dome or bowl <i class="field" style="background:#9ea1a3"></i>flat or single curved <i class="field" style="background:#4d80d6"></i>saddle']
];
function shade(number) {
  uniforms.mode.value = number;
  byId('scale').innerHTML = shadings[number][1]() + hint;
}

scene.results.forEach((result) => pill(byId('methods'), result.name, show));
byId('methods').hidden = scene.results.length < 2;
shadings.forEach(([name]) => pill(byId('shadings'), name, shade));
byId('blend').addEventListener('input', (event) => { uniforms.blend.value = Number(event.target.value); draw(); });
byId('mesh').addEventListener('change', (event) => { wires.visible = event.target.checked; draw(); });
byId('home').addEventListener('click', () => { home(); draw(); });
controls.addEventListener('change', draw);

// How much of the canvas the model covers and how many colours it shows, for those who check the page by program.
function measure() {
  draw();
  const width = context.drawingBufferWidth, height = context.drawingBufferHeight;
  const pixels = new Uint8Array(4 * width * height), colours = new Set();
  context.readPixels(0, 0, width, height, context.RGBA, context.UNSIGNED_BYTE, pixels);
  let covered = 0;
  for (let k = 0; k < pixels.length; k += 4) {
    if (pixels[k + 3] > 0) {
      ++covered;
      colours.add(pixels[k] >> 3 << 10 | pixels[k + 1] >> 3 << 5 | pixels[k + 2] >> 3);
    }
  }
  viewer.dataset.covered = (covered / (width * height)).toFixed(4);
  viewer.dataset.colours = String(colours.size);
}

stage.append(canvas);
viewer.classList.remove('still');
viewer.querySelector('.controls').hidden = false;
message.hidden = true;
// A link may say what to show first: #METHOD,SHADING,BLEND with the names of the buttons, e.g. #arap,zebra,0.5.
const wish = decodeURIComponent(location.hash.slice(1)).toLowerCase().split(',');
const first = Math.max(0, scene.results.findIndex((result) => result.name.toLowerCase() === wish[0]));
const look = Math.max(0, shadings.findIndex(([name]) => name.toLowerCase() === wish[1]));
if (wish[2] >= 0 && wish[2] <= 1) uniforms.blend.value = Number(byId('blend').value = wish[2]);
show(first);
choose(byId('methods'), first);
shade(look);
choose(byId('shadings'), look);
home();
resize();
measure();
viewer.dataset.state = 'ready';
window.addEventListener('resize', resize);
}());
