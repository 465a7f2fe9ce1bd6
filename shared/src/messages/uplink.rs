//! [`Uplink`] on the line: version, number, request, and the time behind requests that are timed. No other one, a chunk of a table
//! least of all, grows by it.

use core::fmt;

use serde::de::{Error, SeqAccess, Visitor};
use serde::ser::SerializeTuple;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Uplink;

/// Fields of a timed one.
const FIELDS: usize = 4;

impl Serialize for Uplink {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let timed = self.request.is_timed();
        let mut fields = serializer.serialize_tuple(FIELDS - usize::from(!timed))?;
        fields.serialize_element(&self.version)?;
        fields.serialize_element(&self.number)?;
        fields.serialize_element(&self.request)?;
        if timed {
            fields.serialize_element(&self.heard_ms)?;
        }
        fields.end()
    }
}

impl<'de> Deserialize<'de> for Uplink {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Fields;

        impl<'de> Visitor<'de> for Fields {
            type Value = Uplink;

            fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("an uplink")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut fields: A) -> Result<Uplink, A::Error> {
                let missing = |index| A::Error::invalid_length(index, &self);
                let version = fields.next_element()?.ok_or_else(|| missing(0))?;
                let number = fields.next_element()?.ok_or_else(|| missing(1))?;
                let mut uplink = Uplink {
                    version,
                    number,
                    request: fields.next_element()?.ok_or_else(|| missing(2))?,
                    heard_ms: 0,
                };
                if uplink.request.is_timed() {
                    uplink.heard_ms = fields.next_element()?.ok_or_else(|| missing(3))?;
                }
                Ok(uplink)
            }
        }

        deserializer.deserialize_tuple(FIELDS, Fields)
    }
}
