"""A path tracer for glTF scenes. It shares no code with jni/, so that one checks the other."""
