//! Defaults with a user's keys in place of their own.
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::SpecError;

/// The default with the user's keys in place of its own.
pub(crate) fn merged<T: Serialize + DeserializeOwned>(
    default: &T,
    changes: &toml::Table,
) -> Result<T, SpecError> {
    let fail = |message: String| SpecError::Core { message };
    let mut table = toml::Table::try_from(default).map_err(|e| fail(e.to_string()))?;
    overlay(&mut table, changes);
    table.try_into().map_err(|e: toml::de::Error| fail(e.message().to_owned()))
}

fn overlay(table: &mut toml::Table, changes: &toml::Table) {
    for (key, change) in changes {
        match (table.get_mut(key), change) {
            (Some(toml::Value::Table(inner)), toml::Value::Table(change)) => overlay(inner, change),
            _ => {
                table.insert(key.clone(), change.clone());
            }
        }
    }
}
