// OpenSSL's objects, each freed by its holder, and its errors as ours. For the sources of this folder only.
#pragma once

#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <openssl/pkcs7.h>
#include <openssl/x509.h>

#include <memory>
#include <string>

#include "foothold/security/error.hpp"

namespace foothold::security {

template <auto free>
struct FreedBy {
  template <class T>
  void operator()(T* object) const {
    free(object);
  }
};

using Bio = std::unique_ptr<BIO, FreedBy<BIO_free_all>>;
using Key = std::unique_ptr<EVP_PKEY, FreedBy<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, FreedBy<X509_free>>;
using Revocations = std::unique_ptr<X509_CRL, FreedBy<X509_CRL_free>>;
using Name = std::unique_ptr<X509_NAME, FreedBy<X509_NAME_free>>;
using Signed = std::unique_ptr<PKCS7, FreedBy<PKCS7_free>>;
using Store = std::unique_ptr<X509_STORE, FreedBy<X509_STORE_free>>;
using Number = std::unique_ptr<ASN1_INTEGER, FreedBy<ASN1_INTEGER_free>>;
using Moment = std::unique_ptr<ASN1_TIME, FreedBy<ASN1_TIME_free>>;

// "<what>: <OpenSSL's reason>"
inline SecurityError failure(const std::string& what) {
  const unsigned long code = ERR_peek_last_error();
  ERR_clear_error();
  const char* reason = code == 0 ? nullptr : ERR_reason_error_string(code);
  return SecurityError(reason == nullptr ? what : what + ": " + reason);
}

inline void must(bool fine, const char* what) {
  if (!fine) throw failure(std::string("OpenSSL: ") + what);
}

// What was written into a memory BIO.
inline std::string text_of(BIO* bio) {
  char* begin = nullptr;
  const long size = BIO_get_mem_data(bio, &begin);
  return {begin, static_cast<std::size_t>(size)};
}

inline Bio memory() {
  Bio bio(BIO_new(BIO_s_mem()));
  must(bio != nullptr, "no memory");
  return bio;
}

inline Bio memory(const std::string& text) {
  Bio bio(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
  must(bio != nullptr, "no memory");
  return bio;
}

}  // namespace foothold::security
