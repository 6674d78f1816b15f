// The sources of the example's shaders, without "#version" and precision.
#pragma once

extern const char* const vertexShader;
extern const char* const opaqueShader;  // surfaces of the model
extern const char* const glassShader;   // the pane; lookUpGlsl() comes before it
