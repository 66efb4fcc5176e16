// Brushed instrument steel; a model whose specular colour is dark is plastic or cloth instead.
varying vec3 eyePosition;
varying vec3 objectPosition;
varying vec3 objectNormal;
varying vec3 baseColor;

// How much of the metal is stained, 0 to 1: up to where the tool has been in blood (m from its tip, told
// by the texture's matrix, since no texture is on a tool), with an uneven border.
float stained() {
  float reach = gl_TextureMatrix[0][3].x;
  if (reach <= 0.0) return 0.0;
  vec4 rough = noise(objectPosition * vec3(260.0, 260.0, 90.0));
  float border = reach + 0.003 * rough.x;
  float streaks = smoothstep(-0.55, 0.25, noise(objectPosition * vec3(700.0, 700.0, 160.0)).x + 0.4);
  return smoothstep(border + 0.0015, border - 0.0015, objectPosition.z) * mix(0.55, 1.0, streaks);
}

void main() {
  vec3 n0 = normalize(objectNormal);
  // Brush marks run across the long (Z) axis of the tools.
  vec3 marks = objectPosition * vec3(250.0, 250.0, 3000.0);
  vec4 brush = noise(marks) * finer(widest(marks));
  float metal = smoothstep(0.12, 0.35, dot(gl_FrontMaterial.specular.rgb, vec3(0.333)));
  vec3 slope = 0.008 * metal * vec3(brush.y, brush.z, 0.6 * brush.w);
  slope -= dot(slope, n0) * n0;
  vec3 flatEye = normalize(gl_NormalMatrix * n0);
  vec3 n = toWorld(normalize(gl_NormalMatrix * (n0 - slope)));
  vec3 point = pointToWorld(eyePosition), v = toWorld(-normalize(eyePosition));
  if (dot(n, v) < 0.0) n = normalize(n - 2.0 * dot(n, v) * v);

  vec3 tint = fromScreen(baseColor);
  // The tray's cloth and plastic are dull: they do not outshine the field.
  vec3 dull = 0.42 * mix(vec3(dot(tint, vec3(0.2126, 0.7152, 0.0722))), tint, 0.55);
  tint = mix(dull, tint, metal);
  vec3 f0 = mix(vec3(0.04), 0.25 + 0.75 * tint, metal);
  float shine = clamp(gl_FrontMaterial.shininess / 128.0, 0.05, 1.0);
  float rough = mix(0.55, mix(0.42, 0.22, shine), metal);
  float blood = stained();
  tint = mix(tint, mix(vec3(0.20, 0.008, 0.006), vec3(0.07, 0.003, 0.003), metal), blood);  // cloth shows blood's red
  f0 = mix(f0, vec3(0.05), blood);
  rough = mix(rough, 0.25, blood);
  metal *= 1.0 - 0.9 * blood;

  Surroundings around = surroundings(eyePosition, point);
  float lit = lampVisible(eyePosition, flatEye), open = around.open;
  vec3 l0, l1;
  vec3 e0 = lampLight(0, point, l0), e1 = lampLight(1, point, l1);
  vec3 diffuse = e0 * lit * max(dot(n, l0), 0.0) + e1 * open * max(dot(n, l1), 0.0) +
                 ambientLight(n) * open;
  float x = 1.0 - max(dot(n, v), 0.0);
  vec3 f = f0 + (1.0 - f0) * x * x * x * x * x * metal;
  vec3 r = reflect(-v, n);
  // What looks down mirrors the cloth, lit as it is below.
  vec3 cloth = vec3(0.016, 0.032, 0.029) * (0.25 + 0.9 * around.tableLit) * (0.3 + 0.7 * around.tableOpen);
  vec3 mirror = mix(cloth, mirrored(point, r, rough * rough) * (0.25 + 0.75 * open),
                    smoothstep(-0.35, 0.05, r.y));
  mirror = 0.8 * mirror + vec3(0.022, 0.024, 0.026);
  vec3 color = tint * mix(1.0, 0.30, metal) * diffuse + f * mirror * mix(0.5, 1.0, lit);
  color += f * (e0 * lit * max(dot(n, l0), 0.0) * glossLobe(n, l0, v, rough + 0.15) +
                e1 * open * max(dot(n, l1), 0.0) * glossLobe(n, l1, v, rough + 0.15));
  // A blade that is seen edge-on shines by the lamp at the eye.
  float nv = max(dot(n, v), 0.0);
  color += headLight(eyePosition) * nv * (0.6 * f * glossLobe(n, v, v, rough + 0.12) + 0.12 * tint);
  gl_FragColor = vec4(picture(color, eyePosition), 1.0);
}
