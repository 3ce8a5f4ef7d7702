// A plugin for a bslnav of another time.
extern "C" const char* bslnavBasePluginVersion() { return "bslnav base 0"; }
