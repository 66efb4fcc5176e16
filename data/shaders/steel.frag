// Brushed instrument steel; the material of the model tints it. A model whose specular colour is
// dark is painted plastic instead.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;

void main() {
  vec3 n0 = normalize(objectNormal);
  // Brush marks run across the long (Z) axis of the tools.
  vec4 brush = noise(objectPosition * vec3(300.0, 300.0, 4000.0));
  vec3 slope = 0.020 * vec3(brush.y, brush.z, brush.w);
  slope -= dot(slope, n0) * n0;
  vec3 flatEye = normalize(gl_NormalMatrix * n0);
  vec3 n = toWorld(normalize(gl_NormalMatrix * (n0 - slope)));
  vec3 flat_ = toWorld(flatEye);
  vec3 point = pointToWorld(eyePosition), v = toWorld(-normalize(eyePosition));
  if (dot(n, v) < 0.0) n = reflect(n, v);

  float metal = smoothstep(0.15, 0.4, dot(gl_FrontMaterial.specular.rgb, vec3(0.333)));
  vec3 tint = pow(baseColor, vec3(2.2));
  vec3 f0 = mix(vec3(0.045), 0.35 + 0.5 * tint, metal);

  float lit = lampVisible(eyePosition, flatEye), open = openness(eyePosition, point, flat_);
  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = lampLight(1, point, l1);
  vec3 diffuse = e0 * lit * max(dot(n, l0), 0.0) + e1 * max(dot(n, l1), 0.0) +
                 ambientLight(n) * open;
  float nv = max(dot(n, v), 0.0), x = 1.0 - nv;
  vec3 f = f0 + (1.0 - f0) * x * x * x * x * x;
  vec3 r = reflect(-v, n);
  vec3 mirror = roomLight(point, r, mix(0.20, 0.07, metal));
  // What looks down mirrors the lit cloth.
  vec3 cloth = vec3(0.03, 0.13, 0.12) * (0.4 + 0.6 * open);
  mirror = mix(cloth, mirror, smoothstep(-0.2, 0.15, r.y));
  vec3 color = tint * mix(1.0, 0.06, metal) * diffuse + f * mirror * mix(0.35 + 0.65 * open, 1.0, 0.3) *
               mix(0.4, 1.0, lit);
  color += f * (e0 * lit * max(dot(n, l0), 0.0) * glossLobe(n, l0, v, 0.36) +
                e1 * max(dot(n, l1), 0.0) * glossLobe(n, l1, v, 0.36));
  gl_FragColor = vec4(picture(color), 1.0);
}
