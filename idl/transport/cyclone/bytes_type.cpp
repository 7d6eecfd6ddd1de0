// The operations that Cyclone calls on our samples (ddsi_serdata_ops) and on our types (ddsi_sertype_ops).
#include "bytes_type.hpp"

#include <dds/ddsi/ddsi_keyhash.h>
#include <dds/ddsi/q_radmin.h>
#include <dds/ddsrt/heap.h>
#include <dds/ddsrt/md5.h>

#include <cstdio>
#include <limits>
#include <memory>
#include <new>
#include <string>

namespace foothold::transport::cyclone {
namespace {

struct BytesType : ddsi_sertype {
  bool keyed = false;
};

struct BytesSample : ddsi_serdata {
  Key key{};
  std::uint32_t size = 0;
  std::unique_ptr<std::byte[]> bytes;  // `size` of them, then zeros up to a multiple of 4: the wire sends whole words
};

const BytesSample& as_sample(const ddsi_serdata* data) { return *static_cast<const BytesSample*>(data); }
bool keyed(const ddsi_sertype* type) { return static_cast<const BytesType*>(type)->keyed; }

void set_key(BytesSample& sample, const Key& key) {
  sample.key = key;
  std::uint32_t mixed = 0;
  for (const std::uint8_t octet : key) mixed = (mixed ^ octet) * 16777619U;
  sample.hash = mixed;
}

std::unique_ptr<BytesSample> allocate(const ddsi_sertype* type, ddsi_serdata_kind kind, std::size_t size) {
  if (size < kEncapsulation || size > std::numeric_limits<std::uint32_t>::max() / 2) return nullptr;
  if (keyed(type) && size < kEncapsulation + sizeof(Key)) return nullptr;
  auto sample = std::make_unique<BytesSample>();
  ddsi_serdata_init(sample.get(), type, kind);
  const std::size_t words = (size + 3) / 4;
  sample->bytes = std::make_unique_for_overwrite<std::byte[]>(words * 4);
  std::memset(sample->bytes.get() + (words - 1) * 4, 0, 4);
  sample->size = static_cast<std::uint32_t>(size);
  return sample;
}

// The samples' key, once all octets are there. The hash of the type keeps the samples of two types apart.
ddsi_serdata* finish(std::unique_ptr<BytesSample> sample) {
  if (keyed(sample->type)) set_key(*sample, key_of({sample->bytes.get(), sample->size}));
  sample->hash ^= sample->type->serdata_basehash;
  return sample.release();
}

std::uint32_t size_of(const ddsi_serdata* data) { return as_sample(data).size; }

bool equal_key(const ddsi_serdata* a, const ddsi_serdata* b) { return as_sample(a).key == as_sample(b).key; }

void free_sample(ddsi_serdata* data) { delete static_cast<BytesSample*>(data); }

// No exception may pass through Cyclone's C frames: a sample that cannot be built is refused by nullptr.
ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind, const nn_rdata* fragment, std::size_t size) try {
  auto sample = allocate(type, kind, size);
  if (!sample) return nullptr;
  std::size_t filled = 0;
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    // Fragments may overlap; only what is new counts.
    if (fragment->maxp1 <= filled) continue;
    if (fragment->min > filled || fragment->maxp1 > size) return nullptr;
    const unsigned char* payload = NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    std::memcpy(sample->bytes.get() + filled, payload + (filled - fragment->min), fragment->maxp1 - filled);
    filled = fragment->maxp1;
  }
  return filled == size ? finish(std::move(sample)) : nullptr;
} catch (const std::bad_alloc&) {
  return nullptr;
}

ddsi_serdata* from_vectors(const ddsi_sertype* type, ddsi_serdata_kind kind, ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* vectors,
                           std::size_t size) try {
  auto sample = allocate(type, kind, size);
  if (!sample) return nullptr;
  std::size_t filled = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (vectors[i].iov_len > size - filled) return nullptr;
    std::memcpy(sample->bytes.get() + filled, vectors[i].iov_base, vectors[i].iov_len);
    filled += vectors[i].iov_len;
  }
  return filled == size ? finish(std::move(sample)) : nullptr;
} catch (const std::bad_alloc&) {
  return nullptr;
}

// The key of 16 octets is its own hash: what a dispose of another vendor bears.
ddsi_serdata* from_key_hash(const ddsi_sertype* type, const ddsi_keyhash* hash) try {
  auto sample = allocate(type, SDK_KEY, kEncapsulation + sizeof(Key));
  const unsigned char encapsulation[kEncapsulation] = {0, 1, 0, 0};
  std::memcpy(sample->bytes.get(), encapsulation, kEncapsulation);
  std::memcpy(sample->bytes.get() + kEncapsulation, hash->value, sizeof(Key));
  return finish(std::move(sample));
} catch (const std::bad_alloc&) {
  return nullptr;
}

// There are no samples but octets: dds_write, dds_read and dds_take are not for these topics.
ddsi_serdata* from_structure(const ddsi_sertype*, ddsi_serdata_kind, const void*) { return nullptr; }
bool to_structure(const ddsi_serdata*, void*, void**, void*) { return false; }
bool untyped_to_structure(const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) { return false; }

void copy_octets(const ddsi_serdata* data, std::size_t offset, std::size_t size, void* out) {
  std::memcpy(out, as_sample(data).bytes.get() + offset, size);
}

ddsi_serdata* borrow_octets(const ddsi_serdata* data, std::size_t offset, std::size_t size, ddsrt_iovec_t* out) {
  out->iov_base = as_sample(data).bytes.get() + offset;
  out->iov_len = size;
  return ddsi_serdata_ref(data);
}

void return_octets(ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); }

// What Cyclone keeps per instance: the key alone, of no type.
ddsi_serdata* to_untyped(const ddsi_serdata* data) try {
  auto key = std::make_unique<BytesSample>();
  ddsi_serdata_init(key.get(), data->type, SDK_KEY);
  set_key(*key, as_sample(data).key);
  key->hash ^= data->type->serdata_basehash;
  key->type = nullptr;
  return key.release();
} catch (const std::bad_alloc&) {
  return nullptr;
}

std::size_t print(const ddsi_sertype*, const ddsi_serdata* data, char* out, std::size_t size) {
  const int written = std::snprintf(out, size, "(%u octets)", as_sample(data).size);
  return written < 0 ? 0 : static_cast<std::size_t>(written);
}

void key_hash(const ddsi_serdata* data, ddsi_keyhash* out, bool force_md5) {
  const Key& key = as_sample(data).key;
  if (!force_md5) {
    std::memcpy(out->value, key.data(), key.size());
    return;
  }
  ddsrt_md5_state_t state;
  ddsrt_md5_init(&state);
  ddsrt_md5_append(&state, key.data(), static_cast<unsigned>(key.size()));
  ddsrt_md5_finish(&state, out->value);
}

void free_type(ddsi_sertype* type) {
  ddsi_sertype_fini(type);
  delete static_cast<BytesType*>(type);
}

// Loans and structures do not exist here, so these have nothing to do.
void zero_samples(const ddsi_sertype*, void*, std::size_t) {}
void reallocate_samples(void**, const ddsi_sertype*, void*, std::size_t, std::size_t) {}
void free_samples(const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {}

bool equal_type(const ddsi_sertype* a, const ddsi_sertype* b) { return keyed(a) == keyed(b); }
std::uint32_t hash_type(const ddsi_sertype* type) { return keyed(type) ? 1U : 0U; }

constexpr ddsi_serdata_ops kSampleOperations = {
    .eqkey = equal_key,
    .get_size = size_of,
    .from_ser = from_fragments,
    .from_ser_iov = from_vectors,
    .from_keyhash = from_key_hash,
    .from_sample = from_structure,
    .to_ser = copy_octets,
    .to_ser_ref = borrow_octets,
    .to_ser_unref = return_octets,
    .to_sample = to_structure,
    .to_untyped = to_untyped,
    .untyped_to_sample = untyped_to_structure,
    .free = free_sample,
    .print = print,
    .get_keyhash = key_hash,
};

constexpr ddsi_sertype_ops kTypeOperations = {
    .version = ddsi_sertype_v0,
    .arg = nullptr,
    .free = free_type,
    .zero_samples = zero_samples,
    .realloc_samples = reallocate_samples,
    .free_samples = free_samples,
    .equal = equal_type,
    .hash = hash_type,
};

}  // namespace

ddsi_sertype* new_bytes_type(const TopicTraits& topic) {
  auto type = std::make_unique<BytesType>();
  type->keyed = topic.keyed;
  ddsi_sertype_init(type.get(), std::string(topic.type).c_str(), &kTypeOperations, &kSampleOperations, !topic.keyed);
  type->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  return type.release();
}

ddsi_serdata* new_sample(const ddsi_sertype* type, std::span<const std::byte> message) {
  auto sample = allocate(type, SDK_DATA, message.size());
  std::memcpy(sample->bytes.get(), message.data(), message.size());
  return finish(std::move(sample));
}

std::span<const std::byte> octets(const ddsi_serdata* sample) {
  const BytesSample& bytes = as_sample(sample);
  return {bytes.bytes.get(), bytes.size};
}

}  // namespace foothold::transport::cyclone
