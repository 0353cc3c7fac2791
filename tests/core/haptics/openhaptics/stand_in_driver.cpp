// The library that the driver brings along; its absence is what a test looks at.
extern "C" int standInDriver();
int standInDriver() { return 42; }
