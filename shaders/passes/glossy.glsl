// glTF's metallic-roughness materials (glTF 2.0, appendix B: GGX with alpha = roughness^2, Schlick's Fresnel
// term). The sun and the punctual lights use the formulas of the appendix. Indirect specular light is a blend
// of rays around the mirror direction (passes/gloss.frag) and, for rough surfaces, of face irradiance
// (passes/shade.frag).

// Between these roughnesses the rays give way to face irradiance on materials that are no metals. They
// reflect a few per cent, and the many rays of a gather have less noise. Nothing hides the lobe of a metal.
const float roughFrom = 0.2;
const float roughTo = 0.9;
// From this roughness on, half the resolution is enough: 0.1, less the rounding to 8 bits. Below, one ray
// along the mirror direction stands for the lobe, which is a degree wide.
const float halfFrom = 0.097;
// From this roughness on, a quarter of the resolution is enough for materials that are no metals.
const float quarterFrom = 0.27;

// The material of a pixel.
struct Brdf {
    mediump vec3 diffuse;  // diffuse albedo
    mediump vec3 f0;       // Schlick's term at normal incidence
    mediump float f90;     // Schlick's term at grazing incidence; 0: the surface is Lambertian
    mediump float roughness;
    mediump float
        lobeShare;  // the share of the lobe's rays in the reflected light; the rest is face irradiance
    vec3 toEye;     // unit length
};

// Metals reflect specularly up to the roughness 1. The reflection of other materials fades out from .9 on, so
// that those of roughness 1, which are most, are Lambertian and need no gloss in the G-buffer.
Brdf brdfOf(mediump vec3 albedo, mediump float metallic, mediump float roughness, vec3 toEye) {
    mediump float fade = clamp((1.0 - roughness) * 10.0, 0.0, 1.0);
    return Brdf(albedo * (1.0 - metallic), mix(vec3(0.04 * fade), albedo, metallic), mix(fade, 1.0, metallic),
                roughness, mix(1.0 - smoothstep(roughFrom, roughTo, roughness), 1.0, metallic), toEye);
}

bool hasLobe(Brdf brdf) {
    return brdf.lobeShare > 0.0;
}

// The fifth power, without the logarithm of pow().
float power5(float x) {
    float square = x * x;
    return square * square * x;
}

vec3 schlick(Brdf brdf, float cosine) {
    return brdf.f0 + (brdf.f90 - brdf.f0) * power5(1.0 - cosine);
}

// Pi times the radiance towards the eye, without shadow, by a punctual light that gives a surface that faces
// it the irradiance 1.
vec3 evaluateBrdf(Brdf brdf, vec3 normal, vec3 toLight) {
    float cosLight = dot(normal, toLight);
    if (cosLight <= 0.0) return vec3(0.0);
    if (brdf.f90 == 0.0) return brdf.diffuse * cosLight;
    float cosEye = max(dot(normal, brdf.toEye), 1e-3);
    vec3 halfway = normalize(toLight + brdf.toEye);
    float cosHalf = max(dot(normal, halfway), 0.0);
    float alpha = brdf.roughness * brdf.roughness, alpha2 = max(alpha * alpha, 1e-6);
    float d = cosHalf * cosHalf * (alpha2 - 1.0) + 1.0;
    float visibility = 1.0 / ((cosLight + sqrt(alpha2 + (1.0 - alpha2) * cosLight * cosLight)) *
                              (cosEye + sqrt(alpha2 + (1.0 - alpha2) * cosEye * cosEye)));
    vec3 fresnel = schlick(brdf, clamp(dot(brdf.toEye, halfway), 0.0, 1.0));
    return min((brdf.diffuse * (1.0 - fresnel) + fresnel * (alpha2 / (d * d) * visibility)) * cosLight, 6e4);
}

// Factor on the diffuse albedo for light from all directions: the light that is not reflected specularly. For
// f0 = 0 and f90 = 1 the mean of Schlick's term, weighted by the cosine, is 0.028 (1 - cosEye)^3 with an
// error below 0.001.
mediump vec3 diffuseAlbedoScale(Brdf brdf, vec3 normal) {
    mediump float grazing = 1.0 - clamp(dot(normal, brdf.toEye), 0.0, 1.0);
    return (1.0 - brdf.f0) * (1.0 - 0.028 * brdf.f90 * grazing * grazing * grazing);
}

// The directional albedo of the specular reflection: the integral of the BRDF of appendix B, fitted by least
// squares. `white` is the fit for f0 = 1 with an error below 0.04, `grazing` for f0 = 0 with an error below
// 0.016, for cosines above 0.1.
vec3 specularShare(Brdf brdf, vec3 normal) {
    float cosEye = clamp(dot(normal, brdf.toEye), 0.0, 1.0);
    const mat3 lost = mat3(2.5237, -5.1001, 3.0084, -6.6343, 18.2343, -11.2633, 3.246, -9.7958, 6.4822);
    const mat4x2 grows = mat4x2(0.1251, -0.7847, -0.7077, 10.4161, -14.331, 5.7419, 8.9506, -10.0871);
    vec3 r = vec3(1.0, brdf.roughness, brdf.roughness * brdf.roughness);
    vec3 c = vec3(1.0, cosEye, cosEye * cosEye);
    float white = 1.0 - r.z * dot(r, lost * c);
    float grazing = brdf.f90 * power5(1.0 - cosEye) * exp2(dot(c.xy, grows * vec4(r, r.y * r.z)));
    return brdf.f0 * (white - grazing) + grazing;
}
