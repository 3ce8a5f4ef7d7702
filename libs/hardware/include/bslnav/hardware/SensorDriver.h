#pragma once

#include <string>

namespace bslnav {

/** The whole life of the process of one of MRPT's sensor drivers, as rawlog-grabber runs it: reads
 * the driver's section from a configuration, opens the device, and writes what it observes as
 * messages, until SIGTERM comes or nobody reads any more.
 *  @param ini text with the section, which has a key `driver`
 *  @param out where to write SensorMessages
 *  @return exit code: 0 after SIGTERM, 1 after trouble, which is the last message */
int runSensorDriver(const std::string& ini, const std::string& section, int out);

}  // namespace bslnav
