// A base for bslnav: share/doc/base-protocol.md. Yours to write:
void setWheels(double vx, double vy, double omega);      // m/s, m/s, rad/s
void readOdometry(double& x, double& y, double& phi);    // m, m, rad, since power-on
const char* reasonToStand();                             // "emergency stop", or "": none

double vx, vy, omega;
unsigned long heard_ms, told_ms, watchdog_ms;  // watchdog_ms 0: no hello yet
char line[64];
byte length;

String withSum(const String& payload) {
  byte sum = 0;
  for (unsigned i = 0; i < payload.length(); ++i) sum ^= payload[i];
  char hex[3];
  snprintf(hex, sizeof hex, "%02X", sum);
  return "$" + payload + "*" + hex;
}

void take() {
  line[length] = 0;
  if (length < 5) return;
  line[length - 3] = 0;  // ends the payload, and the numbers in it
  const String payload = line + 1;
  line[length - 3] = '*';
  if (withSum(payload) != line) return;
  double f[3];
  byte n = 0;
  char* at = line + 2;
  for (; *at == ',' && n < 3; ++n) f[n] = strtod(at + 1, &at);
  if (*at != '*') return;
  if (line[1] == 'H' && n == 2 && f[0] == 1) {
    watchdog_ms = f[1];
    Serial.print(withSum(payload) + "\n");
  } else if (line[1] == 'V' && n == 3 && watchdog_ms) {
    vx = f[0], vy = f[1], omega = f[2];
    heard_ms = millis();
  } else if (line[1] == 'X' && n == 0) {
    vx = vy = omega = 0;
  }
}

void setup() { Serial.begin(115200); }

void loop() {
  while (Serial.available()) {
    const char c = Serial.read();
    if (c == '\n') take();
    if (c == '\n') length = 0;
    else if (c != '\r' && length < sizeof line - 1) line[length++] = c;
  }
  const unsigned long now = millis();
  if (now - heard_ms > watchdog_ms) vx = vy = omega = 0;
  setWheels(vx, vy, omega);
  if (watchdog_ms == 0 || now - told_ms < 20) return;
  told_ms = now;
  double x, y, phi;
  readOdometry(x, y, phi);
  Serial.print(withSum("S," + String(now) + "," + String(x, 4) + "," + String(y, 4) + "," + String(phi, 4) + "," +
                       String(vx, 4) + "," + String(vy, 4) + "," + String(omega, 4) + "," + reasonToStand()) + "\n");
}
