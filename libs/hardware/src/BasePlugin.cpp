#include <bslnav/config/Error.h>
#include <bslnav/hardware/BasePlugin.h>
#include <dlfcn.h>

namespace bslnav {
namespace {

constexpr char kExpected[] = "expected a shared library made with BSLNAV_BASE_PLUGIN";

template <typename Function>
Function* symbolOf(void* handle, const std::string& library, const char* name) {
  void* symbol = ::dlsym(handle, name);
  if (!symbol) throw Error(library, std::string("has no ") + name + "; " + kExpected);
  return reinterpret_cast<Function*>(symbol);
}

void* open(const std::string& library) {
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (handle) return handle;
  const char* why = ::dlerror();
  throw Error(library, std::string("cannot be loaded (") + (why ? why : "no reason given") + "); " +
                           kExpected);
}

}  // namespace

std::unique_ptr<Base> loadBase(const std::string& library,
                               const std::map<std::string, std::string>& options) {
  void* handle = open(library);
  auto* version = symbolOf<const char*()>(handle, library, "bslnavBasePluginVersion");
  if (std::string(version()) != BSLNAV_BASE_PLUGIN_VERSION)
    throw Error(library, std::string("was made for '") + version() +
                             "'; expected one made for '" BSLNAV_BASE_PLUGIN_VERSION "'");
  auto* make =
      symbolOf<Base*(const std::map<std::string, std::string>&)>(handle, library, "bslnavMakeBase");
  try {
    return std::unique_ptr<Base>(make(options));
  } catch (const Error& error) {
    throw Error(library, std::string("its base cannot be made: ") + error.what(), error.kind());
  } catch (const std::exception& error) {
    throw Error(library, std::string("its base cannot be made: ") + error.what(), Error::Kind::Run);
  } catch (...) {
    throw Error(library, "its base cannot be made; expected a std::exception that says why",
                Error::Kind::Run);
  }
}

}  // namespace bslnav
