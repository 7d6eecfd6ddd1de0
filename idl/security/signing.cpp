// PKCS #7, detached, with a text header: what `openssl smime -sign -text` makes.
#include "signing.hpp"

namespace foothold::security {
namespace {

constexpr int kForm = PKCS7_DETACHED | PKCS7_TEXT | PKCS7_STREAM;

Store store_of(X509* authority) {
  Store store(X509_STORE_new());
  must(store && X509_STORE_add_cert(store.get(), authority) == 1, "store");
  return store;
}

}  // namespace

std::string sign(const Authority& authority, const std::string& document) {
  const Bio in = memory(document);
  const Signed signature(PKCS7_sign(authority.certificate.get(), authority.key.get(), nullptr, in.get(), kForm));
  must(signature != nullptr, "signature");
  const Bio out = memory();
  must(SMIME_write_PKCS7(out.get(), signature.get(), in.get(), kForm) == 1, "signature");
  return text_of(out.get());
}

std::string verified(X509* authority, const std::string& document, const std::string& from) {
  BIO* content = nullptr;
  const Signed signature(SMIME_read_PKCS7(memory(document).get(), &content));
  const Bio owned(content);
  if (!signature || !owned) throw failure(from + ": is no signed document");
  const Bio out = memory();
  if (PKCS7_verify(signature.get(), nullptr, store_of(authority).get(), content, out.get(), PKCS7_TEXT) != 1)
    throw failure(from + ": is not signed by the authority beside it, or was changed since");
  return text_of(out.get());
}

void verify(X509* authority, X509* certificate, const std::string& from) {
  const Store store = store_of(authority);
  // Times are looked at by whoever asks, in words of its own.
  X509_STORE_set_flags(store.get(), X509_V_FLAG_NO_CHECK_TIME);
  const std::unique_ptr<X509_STORE_CTX, FreedBy<X509_STORE_CTX_free>> context(X509_STORE_CTX_new());
  must(context && X509_STORE_CTX_init(context.get(), store.get(), certificate, nullptr) == 1, "store");
  if (X509_verify_cert(context.get()) == 1) return;
  ERR_clear_error();
  throw SecurityError(from + ": was not issued by the authority beside it (" +
                      X509_verify_cert_error_string(X509_STORE_CTX_get_error(context.get())) + ")");
}

}  // namespace foothold::security
