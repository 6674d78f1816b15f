#include "shaders.h"

const char* const vertexShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinates;
layout(location = 0) uniform mat4 clipFromWorld;
layout(location = 1) uniform mat4 worldFromObject;
out vec3 worldPosition;
out vec3 worldNormal;
out vec2 uv;
void main() {
    worldPosition = (worldFromObject * vec4(position, 1.0)).xyz;
    worldNormal = mat3(worldFromObject) * normal;
    uv = coordinates;
    gl_Position = clipFromWorld * vec4(worldPosition, 1.0);
})";

const char* const opaqueShader = R"(
in vec3 worldPosition;
in vec3 worldNormal;
in vec2 uv;
layout(binding = 0) uniform sampler2D picture;
layout(binding = 1) uniform sampler2D irradiance;
layout(binding = 2) uniform sampler2D sunVisibility;
layout(location = 2) uniform vec3 baseColor;
layout(location = 3) uniform vec3 emission;
layout(location = 4) uniform vec3 directionToSun;
layout(location = 5) uniform vec3 sun;
layout(location = 6) uniform float radianceUnit;
layout(location = 0) out vec4 color;
void main() {
    // The library's pictures are of the same view and size.
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float cosine = max(dot(normalize(worldNormal), directionToSun), 0.0);
    vec3 received = cosine * texelFetch(sunVisibility, pixel, 0).r * sun + texelFetch(irradiance, pixel, 0).rgb;
    vec3 albedo = baseColor * texture(picture, uv).rgb;
    color = vec4(albedo * received * radianceUnit + emission, 1.0);
})";

const char* const glassShader = R"(
in vec3 worldPosition;
in vec3 worldNormal;
layout(location = 2) uniform vec3 tint;
layout(location = 6) uniform float radianceUnit;
layout(location = 0) out vec4 color;
void main() {
    // The pane is frosted: it scatters the light of both sides, and lets half of what is behind it through.
    vec3 normal = normalize(worldNormal);
    vec3 received = irradianceAt(worldPosition, normal) + irradianceAt(worldPosition, -normal);
    color = vec4(0.5 * tint * received * radianceUnit, 0.5);
})";
