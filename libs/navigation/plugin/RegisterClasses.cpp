// Makes bslnav::CHolonomicDwa known to a program that loads this at run time
// (mrpt::system::loadPluginModule), so that its INI file may name it.
#include <bslnav/navigation/CHolonomicDwa.h>
#include <mrpt/core/initializer.h>

MRPT_INITIALIZER(registerBslnavClasses) {
  mrpt::rtti::registerClass(CLASS_ID_NAMESPACE(CHolonomicDwa, bslnav));
}
