// Documents signed by the authority, as S/MIME text: the form that DDS Security asks for.
#pragma once

#include <string>

#include "certificate.hpp"

namespace foothold::security {

std::string sign(const Authority& authority, const std::string& document);
// What was signed. Throws SecurityError if it is not signed by that authority or was changed since.
std::string verified(X509* authority, const std::string& document, const std::string& from);
// Throws SecurityError if the authority did not issue it.
void verify(X509* authority, X509* certificate, const std::string& from);

}  // namespace foothold::security
