//! An advisory lock on a file or folder that ends when its value does.

use std::fs::{File, TryLockError};

/// A lock that is given back when this value goes, and by the operating system when the process is killed.
///
/// A lock belongs to the open file and not to the descriptor. A program that another thread is starting holds copies of all
/// descriptors until it is loaded, so that closing ours would leave the lock in place for that moment: it is given
/// back by name.
#[derive(Debug)]
pub struct FileLock(File);

impl FileLock {
    /// Takes the lock, or says at once that another has it.
    ///
    /// # Errors
    /// [`TryLockError::WouldBlock`] where another has it; where the file system has no locks, what it said.
    pub fn try_take(file: File) -> Result<FileLock, TryLockError> {
        file.try_lock()?;
        Ok(FileLock(file))
    }
}

impl Drop for FileLock {
    fn drop(&mut self) {
        // Where this fails the lock goes with the descriptor.
        let _ = self.0.unlock();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_goes_with_its_value_even_while_its_descriptor_is_copied() {
        let dir = tempfile::tempdir().unwrap();
        let open = || File::options().create(true).append(true).open(dir.path().join("lock")).unwrap();
        let file = open();
        let copy = file.try_clone().unwrap();
        let held = FileLock::try_take(file).unwrap();
        assert!(matches!(FileLock::try_take(open()), Err(TryLockError::WouldBlock)));
        drop(held);
        drop(FileLock::try_take(open()).unwrap());
        drop(copy);
    }
}
