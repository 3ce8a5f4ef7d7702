#include <bslnav/hardware/Base.h>
