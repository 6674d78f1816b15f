"""Path-traced truth of a glTF scene. Shares no code with jni/: one checks the other."""
