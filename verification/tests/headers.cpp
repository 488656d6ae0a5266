// The headers that every test begins with are precompiled here, once for all test programs.
