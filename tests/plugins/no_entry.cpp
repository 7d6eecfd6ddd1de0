// A shared library that is no plugin.
extern "C" __attribute__((visibility("default"))) int foothold_is_not_in_here() { return 0; }
