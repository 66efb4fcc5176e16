// Liver, shaded triangle by triangle.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying float cutShare;
varying vec3 baseColor;

void main() {
  // Open surfaces have a back; a folded triangle whose normal still faces the eye has none.
  bool facing = gl_FrontFacing || dot(gl_NormalMatrix * objectNormal, eyePosition) < 0.0;
  vec3 n = normalize(facing ? objectNormal : -objectNormal);
  float bend = length(fwidth(objectNormal)) / max(length(fwidth(eyePosition)), 1e-5);
  gl_FragColor = vec4(liver(objectPosition, widest(objectPosition), n, bend, cutOrRim(cutShare, objectPosition), eyePosition, baseColor), 1.0);
}
