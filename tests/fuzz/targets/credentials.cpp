// Certificates, keys, revocations and signed documents of DDS Security, as a folder of credentials may hold them. The first octet
// chooses what the octets are taken for.
#include "../fuzzing.hpp"
#include "certificate.hpp"
#include "foothold/security/error.hpp"
#include "signing.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  static const auto kAuthority = [] {
    security::Key key = security::new_key();
    return security::authority_certificate(key.get(), 86400.0);
  }();
  if (size == 0) return 0;
  const std::string text = fuzz::text_of(data + 1, size - 1);
  try {
    switch (data[0] % 4) {
      case 0: {
        const security::Certificate certificate = security::certificate_from(text, "file");
        security::subject_text(certificate.get());
        security::fits_vendor(certificate.get(), "cyclone");
        security::subject_of(certificate.get(), "file");
        break;
      }
      case 1:
        security::key_from(text, "file");
        break;
      case 2: {
        const security::Revocations revoked = security::revocations_from(text, "file");
        security::is_revoked(revoked.get(), kAuthority.get());
        break;
      }
      default:
        security::verified(kAuthority.get(), text, "file");
        fuzz::demand(false, "what this authority did not sign is refused");
    }
  } catch (const security::SecurityError&) {
  }
  return 0;
}
